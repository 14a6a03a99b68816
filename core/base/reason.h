// Why something failed or was refused, as a value: an English sentence that this program has as a constant, and the values in
// it. The constants of a room stand in one file, such as core/vehicle/reasons.h. Command lines show the English text; the
// window translates the sentence (core/engine/text/qt_text.h), and `update_translations` collects it by the function
// sentence().
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace skyseal {

class Reason;

/// An English sentence, or a part of one, without a full stop. %1 to %9 stand for values.
class Sentence
{
public:
    constexpr Sentence(const char *context, const char *english) : m_context(context), m_english(english) {}

    /// The reason with these values: each a text, a whole number, or another reason.
    template<typename... Values> Reason operator()(Values &&...values) const;

    const char *context() const { return m_context; } ///< of the translation
    const char *english() const { return m_english; }

private:
    const char *m_context, *m_english;
};

/// Both must be literals. `context` is that of the translations.
constexpr Sentence sentence(const char *context, const char *english)
{
    return {context, english};
}

class Reason
{
public:
    using Translate = std::string (*)(const Sentence &);

    Reason() = default;
    /// A text that is shown as it is: of the operating system, of the vehicle, a name.
    Reason(std::string text) : m_text(std::move(text)) {}
    Reason(const char *text) : m_text(text) {}
    Reason(const Sentence &sentence, std::vector<Reason> values = {}) : m_sentence(sentence), m_values(std::move(values)) {}

    bool empty() const { return !m_sentence && m_text.empty(); }
    /// English, in UTF-8. Texts from outside may hold any characters.
    std::string text() const;
    /// In the words that `translate` finds for each sentence.
    std::string text(Translate translate) const;

    /// The same words.
    friend bool operator==(const Reason &a, const Reason &b) { return a.text() == b.text(); }

private:
    std::string m_text;
    std::optional<Sentence> m_sentence;
    std::vector<Reason> m_values;
};

namespace detail {

template<typename Value> Reason valueOf(Value &&value)
{
    if constexpr (requires { std::to_string(value); })
        return std::to_string(value);
    else
        return std::forward<Value>(value);
}

} // namespace detail

template<typename... Values> Reason Sentence::operator()(Values &&...values) const
{
    return {*this, {detail::valueOf(std::forward<Values>(values))...}};
}

} // namespace skyseal
