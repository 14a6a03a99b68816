// The words of one step of a flight script, taken from the front, with what is needed to say exactly where something is
// wrong.
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace skyseal::vehicle {

/// Views the script; the script outlives it.
class ScriptTokens
{
public:
    /// `column` is that of the first character, `step` the number of the step; both 1-based.
    ScriptTokens(std::string_view text, std::size_t column, std::size_t step);

    bool atEnd() const { return m_rest.empty(); }
    std::string_view rest() const { return m_rest; }
    std::size_t column() const { return m_column; }

    /// The next word up to a space; empty at the end.
    std::string_view peek() const;
    /// The letters, digits and underscores that come next.
    std::string_view peekName() const;
    /// How many digits stand before a colon that comes next; 0 when that is not what comes.
    std::size_t digitsBeforeColon() const;

    std::string_view take();
    /// Takes these characters (not a whole word) when they come next.
    bool takeIf(std::string_view text);
    void skip(std::size_t count);

    /// The next word as a number within the limits; otherwise an error that names what was expected.
    Result<double, InputError> number(const std::string &expected, double least, double most);
    Result<std::int64_t, InputError> wholeNumber(const std::string &expected, std::int64_t least, std::int64_t most);
    /// Seconds, up to a day.
    Result<Duration, InputError> duration(const std::string &expected);

    /// "step 2: expected a number, found 'ten'" at the current column.
    InputError error(const std::string &expected) const;
    /// The same about what was taken last.
    InputError errorBefore(const std::string &expected) const;

private:
    InputError errorAt(std::size_t column, std::string_view found, const std::string &expected) const;

    std::string_view m_rest;
    std::size_t m_column;
    std::size_t m_step;
    std::string_view m_last;
    std::size_t m_lastColumn;
};

} // namespace skyseal::vehicle
