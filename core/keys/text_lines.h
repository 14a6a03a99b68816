// Iterates over the lines of a text, with line numbers. Accepts Windows line ends.
#pragma once

#include <optional>
#include <string_view>

namespace skyseal::keys {

class TextLines
{
public:
    explicit TextLines(std::string_view text) : m_rest(text) {}

    bool atEnd() const { return m_rest.empty(); }
    /// The number of the line returned last, from 1.
    std::size_t number() const { return m_number; }

    /// The next line; empty at the end.
    std::string_view next()
    {
        ++m_number;
        const std::size_t end = m_rest.find('\n');
        std::string_view line = m_rest.substr(0, end);
        m_rest = end == std::string_view::npos ? std::string_view() : m_rest.substr(end + 1);
        if (line.ends_with('\r'))
            line.remove_suffix(1);
        return line;
    }

    /// The next line that is neither empty nor a comment (#).
    std::optional<std::string_view> nextContent()
    {
        while (!atEnd()) {
            const std::string_view line = next();
            if (!line.empty() && !line.starts_with('#'))
                return line;
        }
        return std::nullopt;
    }

private:
    std::string_view m_rest;
    std::size_t m_number = 0;
};

} // namespace skyseal::keys
