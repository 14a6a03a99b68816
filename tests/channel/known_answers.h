// The known answers that PROTOCOL.md gives to implementers of a peer, read from the document itself.
#pragma once

#include "core/base/bytes.h"

#include <map>
#include <set>
#include <string>

namespace skyseal::test {

/// Examples by name. Remembers each requested name, so that a test can find examples that were never checked.
class KnownAnswers
{
public:
    /// Reads the section "Known answers". Empty when there is none; `problem` then says why.
    static KnownAnswers read(const std::string &path);

    /// The bytes of an example (of a text: its characters); empty if the document does not contain the name.
    const Bytes &operator[](const std::string &name) const;
    std::string text(const std::string &name) const { return std::string(asText((*this)[name])); }
    bool empty() const { return m_examples.empty(); }
    std::size_t size() const { return m_examples.size(); }
    const std::string &problem() const { return m_problem; }
    std::set<std::string> unused() const;

private:
    void take(const std::string &line);

    std::map<std::string, Bytes> m_examples;
    mutable std::set<std::string> m_asked;
    std::string m_last; ///< the example that a line of bare hex continues
    std::string m_problem;
};

} // namespace skyseal::test
