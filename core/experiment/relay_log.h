// The log that the relay of an impaired link writes (skyseal-cli impair --json --drops), as a file. Each line of a dropped
// datagram has the sums so far, so that the newest one tells all. Plain object on the thread of its owner.
#pragma once

#include "core/experiment/results.h"

#include <QtCore/QByteArray>
#include <QtCore/QString>

namespace skyseal::experiment {

class RelayLog
{
public:
    /// The relay must open the file to append: a log that grew too large is cut off.
    explicit RelayLog(QString file) : m_file(std::move(file)) {}

    /// Begins an empty log for a relay that is to start.
    void begin();
    /// Sums of what the log holds now; those of the call before where it cannot be read.
    const Counted::Relay &read();

    static constexpr qint64 kMostBytes = 8 << 20; ///< it is cut off when it was read at this size

private:
    void note(const QByteArray &lines);

    QString m_file;
    qint64 m_seen = 0; ///< bytes of whole lines that were read
    Counted::Relay m_dropped;
};

} // namespace skyseal::experiment
