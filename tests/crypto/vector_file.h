// Reads the project's own small vector files under tests/data/vectors.
#pragma once

#include "core/base/hex.h"

#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace skyseal::test {

/// One paragraph of "name = value" lines.
class Vector
{
public:
    void set(const std::string &name, const std::string &value) { m_values[name] = value; }
    bool isEmpty() const { return m_values.empty(); }
    bool has(const std::string &name) const { return m_values.contains(name); }
    std::string text(const std::string &name) const
    {
        const auto found = m_values.find(name);
        return found == m_values.end() ? std::string() : found->second;
    }
    /// The bytes of a value in hex; empty for "" and for a value that is missing.
    Bytes bytes(const std::string &name) const { return fromHex(text(name)).value_or(Bytes()); }

private:
    std::map<std::string, std::string> m_values;
};

/// All vectors of a file; none if it cannot be read, so callers check that there are some.
inline std::vector<Vector> readVectors(const std::string &file)
{
    std::ifstream in(std::string(SKYSEAL_SOURCE_DIR "/tests/data/vectors/") + file);
    std::vector<Vector> out;
    Vector current;
    const auto flush = [&] {
        if (!current.isEmpty())
            out.push_back(std::exchange(current, Vector()));
    };
    for (std::string line; std::getline(in, line);) {
        const std::size_t equals = line.find(" = ");
        if (line.empty())
            flush();
        else if (line[0] != '#' && equals != std::string::npos)
            current.set(line.substr(0, equals), line.substr(equals + 3));
    }
    flush();
    return out;
}

} // namespace skyseal::test
