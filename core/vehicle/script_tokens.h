// Splits one step of a flight script into tokens, from front to back, and keeps the positions for exact error
// messages.
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace skyseal::vehicle {

/// A view of the script, which must outlive it.
class ScriptTokens
{
public:
    /// `column` is that of the first character, `step` the number of the step; both 1-based.
    /// Errors in a text that is no script, with the step 0, name no step.
    ScriptTokens(std::string_view text, std::size_t column, std::size_t step);

    bool atEnd() const { return m_rest.empty(); }
    std::string_view rest() const { return m_rest; }
    std::size_t column() const { return m_column; }

    /// The next token up to a space; empty at the end.
    std::string_view peek() const;
    /// The letters, digits and underscores that follow.
    std::string_view peekName() const;
    /// Number of digits if digits and a colon follow; 0 otherwise.
    std::size_t digitsBeforeColon() const;

    std::string_view take();
    /// Consumes these characters (not a whole token) if they follow.
    bool takeIf(std::string_view text);
    void skip(std::size_t count);

    /// The next token as a number within the limits; otherwise an error that names `expected`.
    Result<double, InputError> number(const Reason &expected, double least, double most);
    Result<std::int64_t, InputError> wholeNumber(const Reason &expected, std::int64_t least, std::int64_t most);
    /// Seconds, up to a day.
    Result<Duration, InputError> duration(const Reason &expected);

    /// "step 2: expected a number, found 'ten'" at the current column.
    InputError error(const Reason &expected) const;
    /// The same for the token consumed last.
    InputError errorBefore(const Reason &expected) const;

private:
    InputError errorAt(std::size_t column, std::string_view found, const Reason &expected) const;

    std::string_view m_rest;
    std::size_t m_column;
    std::size_t m_step;
    std::string_view m_last;
    std::size_t m_lastColumn;
};

} // namespace skyseal::vehicle
