// What a soak measured: how soon the chain worked again after each kind of disturbance, and the memory and descriptors of
// each life of a program.
#pragma once

#include "tests/integration/soak_chain.h"

#include <map>
#include <vector>

namespace skyseal::test {

class SoakFigures
{
public:
    /// Seconds until the first frame reached the client, and until every part worked.
    void noteRecovery(const QByteArray &disturbance, double firstFrame, double all);
    /// Call it from time to time; `now` in seconds.
    void noteProcesses(const SoakChain &chain, double now);
    /// What grew too much, in words; empty: nothing.
    QString growth() const;
    void print() const;

private:
    struct Life
    {
        qint64 pid = 0;
        double since = 0;
        qint64 warmMemory = 0; ///< kB, once the program was warm; 0: it is not
        qsizetype warmDescriptors = 0;
    };
    /// Of the life that grew most, among those that were long enough.
    struct Growth
    {
        int lives = 0;
        double longest = 0; ///< s
        qint64 memory = 0, peak = 0;
        qsizetype descriptors = 0;
    };
    struct Recovery
    {
        std::vector<double> firstFrame, all;
    };

    std::map<QByteArray, Recovery> m_recoveries;
    std::map<Part, Life> m_lives;
    std::map<Part, Growth> m_growth;
};

} // namespace skyseal::test
