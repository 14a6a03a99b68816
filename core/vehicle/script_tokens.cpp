#include "core/vehicle/script_tokens.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace skyseal::vehicle {

namespace {

constexpr bool isSpace(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

constexpr bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

constexpr bool isNameCharacter(char c)
{
    return isDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

constexpr std::size_t kLongestQuote = 40;

} // namespace

ScriptTokens::ScriptTokens(std::string_view text, std::size_t column, std::size_t step)
    : m_rest(text), m_column(column), m_step(step), m_lastColumn(column)
{
    while (!m_rest.empty() && isSpace(m_rest.back()))
        m_rest.remove_suffix(1);
    skip(0);
}

std::string_view ScriptTokens::peek() const
{
    const auto end = std::find_if(m_rest.begin(), m_rest.end(), isSpace);
    return m_rest.substr(0, static_cast<std::size_t>(end - m_rest.begin()));
}

std::string_view ScriptTokens::peekName() const
{
    const auto end = std::find_if_not(m_rest.begin(), m_rest.end(), isNameCharacter);
    return m_rest.substr(0, static_cast<std::size_t>(end - m_rest.begin()));
}

std::size_t ScriptTokens::digitsBeforeColon() const
{
    const auto end = std::find_if_not(m_rest.begin(), m_rest.end(), isDigit);
    const auto colon = std::find_if_not(end, m_rest.end(), isSpace);
    return colon != m_rest.end() && *colon == ':' ? static_cast<std::size_t>(end - m_rest.begin()) : 0;
}

std::string_view ScriptTokens::take()
{
    const std::string_view word = peek();
    skip(word.size());
    return word;
}

bool ScriptTokens::takeIf(std::string_view text)
{
    if (m_rest.substr(0, text.size()) != text)
        return false;
    skip(text.size());
    return true;
}

void ScriptTokens::skip(std::size_t count)
{
    m_last = m_rest.substr(0, count);
    m_lastColumn = m_column;
    while (count < m_rest.size() && isSpace(m_rest[count]))
        ++count;
    m_rest.remove_prefix(count);
    m_column += count;
}

Result<double, InputError> ScriptTokens::number(const Reason &expected, double least, double most)
{
    const std::string_view word = peek();
    const char *begin = word.data();
    const char *end = begin + word.size();
    if (word.size() > 1 && word[0] == '+' && word[1] != '-')
        ++begin; // from_chars knows no plus
    double value = 0;
    const auto [stop, problem] = std::from_chars(begin, end, value);
    if (word.empty() || problem != std::errc() || stop != end || !std::isfinite(value) || value < least || value > most)
        return tl::make_unexpected(error(expected));
    skip(word.size());
    return value;
}

Result<std::int64_t, InputError> ScriptTokens::wholeNumber(const Reason &expected, std::int64_t least, std::int64_t most)
{
    const std::string_view word = peek();
    std::int64_t value = 0;
    const auto [stop, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || problem != std::errc() || stop != word.data() + word.size() || value < least || value > most)
        return tl::make_unexpected(error(expected));
    skip(word.size());
    return value;
}

Result<Duration, InputError> ScriptTokens::duration(const Reason &expected)
{
    const auto value = number(expected, 0, 86400);
    if (!value)
        return tl::make_unexpected(value.error());
    return std::chrono::round<Duration>(std::chrono::duration<double>(*value));
}

InputError ScriptTokens::error(const Reason &expected) const
{
    return errorAt(m_column, peek(), expected);
}

InputError ScriptTokens::errorBefore(const Reason &expected) const
{
    return errorAt(m_lastColumn, m_last, expected);
}

InputError ScriptTokens::errorAt(std::size_t column, std::string_view found, const Reason &expected) const
{
    const std::string quoted = "'" + std::string(found.substr(0, kLongestQuote)) + (found.size() > kLongestQuote ? "…'" : "'");
    const Reason there = !found.empty() ? Reason(quoted)
        : m_step == 0                   ? sentence("Reason", "nothing")
                                        : sentence("Reason", "the end of the step");
    const Reason message = sentence("Reason", "expected %1, found %2")(expected, there);
    return {m_step == 0 ? message : sentence("Reason", "step %1: %2")(m_step, message), {}, 1, column};
}

} // namespace skyseal::vehicle
