#include "core/noise/handshake_pattern.h"

#include <algorithm>
#include <array>

namespace skyseal::noise {

namespace {

struct Row
{
    std::string_view name;
    std::string_view initiatorPreMessage;
    std::string_view responderPreMessage;
    std::string_view messages; ///< tokens by ",", messages by "|"
};

// Section 7.4 (one-way), 7.5 (fundamental), 18.1 (deferred).
constexpr std::array kRows{
    Row{"N", "", "s", "e,es"},
    Row{"K", "s", "s", "e,es,ss"},
    Row{"X", "", "s", "e,es,s,ss"},

    Row{"NN", "", "", "e|e,ee"},
    Row{"NK", "", "s", "e,es|e,ee"},
    Row{"NX", "", "", "e|e,ee,s,es"},
    Row{"KN", "s", "", "e|e,ee,se"},
    Row{"KK", "s", "s", "e,es,ss|e,ee,se"},
    Row{"KX", "s", "", "e|e,ee,se,s,es"},
    Row{"XN", "", "", "e|e,ee|s,se"},
    Row{"XK", "", "s", "e,es|e,ee|s,se"},
    Row{"XX", "", "", "e|e,ee,s,es|s,se"},
    Row{"IN", "", "", "e,s|e,ee,se"},
    Row{"IK", "", "s", "e,es,s,ss|e,ee,se"},
    Row{"IX", "", "", "e,s|e,ee,se,s,es"},

    Row{"NK1", "", "s", "e|e,ee,es"},
    Row{"NX1", "", "", "e|e,ee,s|es"},
    Row{"X1N", "", "", "e|e,ee|s|se"},
    Row{"X1K", "", "s", "e,es|e,ee|s|se"},
    Row{"XK1", "", "s", "e|e,ee,es|s,se"},
    Row{"X1K1", "", "s", "e|e,ee,es|s|se"},
    Row{"X1X", "", "", "e|e,ee,s,es|s|se"},
    Row{"XX1", "", "", "e|e,ee,s|es,s,se"},
    Row{"X1X1", "", "", "e|e,ee,s|es,s|se"},
    Row{"K1N", "s", "", "e|e,ee|se"},
    Row{"K1K", "s", "s", "e,es|e,ee|se"},
    Row{"KK1", "s", "s", "e|e,ee,se,es"},
    Row{"K1K1", "s", "s", "e|e,ee,es|se"},
    Row{"K1X", "s", "", "e|e,ee,s,es|se"},
    Row{"KX1", "s", "", "e|e,ee,se,s|es"},
    Row{"K1X1", "s", "", "e|e,ee,s|se,es"},
    Row{"I1N", "", "", "e,s|e,ee|se"},
    Row{"I1K", "", "s", "e,es,s|e,ee|se"},
    Row{"IK1", "", "s", "e,s|e,ee,se,es"},
    Row{"I1K1", "", "s", "e,s|e,ee,es|se"},
    Row{"I1X", "", "", "e,s|e,ee,s,es|se"},
    Row{"IX1", "", "", "e,s|e,ee,se,s|es"},
    Row{"I1X1", "", "", "e,s|e,ee,s|se,es"},
};

/// Removes the text up to the next separator, and the separator, from `text`; returns the part before it.
std::string_view takeUpTo(std::string_view &text, char separator)
{
    const std::size_t at = text.find(separator);
    const std::string_view part = text.substr(0, at);
    text = at == std::string_view::npos ? std::string_view() : text.substr(at + 1);
    return part;
}

Token tokenNamed(std::string_view name)
{
    static constexpr std::array<std::string_view, 6> kNames{"e", "s", "ee", "es", "se", "ss"};
    return static_cast<Token>(std::find(kNames.begin(), kNames.end(), name) - kNames.begin());
}

MessagePattern tokens(std::string_view text)
{
    MessagePattern out;
    while (!text.empty())
        out.push_back(tokenNamed(takeUpTo(text, ',')));
    return out;
}

/// Applies "psk0" (before the first message's tokens) or "pskN" (after those of message N).
bool addPsk(HandshakePattern &pattern, std::string_view modifier)
{
    if (modifier.size() != 4 || !modifier.starts_with("psk") || modifier[3] < '0' || modifier[3] > '9')
        return false;
    const auto place = static_cast<std::size_t>(modifier[3] - '0');
    if (place > pattern.messages.size())
        return false;
    if (place == 0)
        pattern.messages.front().insert(pattern.messages.front().begin(), Token::Psk);
    else
        pattern.messages[place - 1].push_back(Token::Psk);
    ++pattern.pskCount;
    return true;
}

} // namespace

std::string HandshakePattern::protocolName() const
{
    return "Noise_" + name + "_25519_ChaChaPoly_BLAKE2b";
}

std::optional<HandshakePattern> handshakePattern(std::string_view name)
{
    const std::size_t modifiersAt = std::min(name.find("psk"), name.size());
    std::string_view modifiers = name.substr(modifiersAt);
    const auto row = std::find_if(kRows.begin(), kRows.end(),
                                  [base = name.substr(0, modifiersAt)](const Row &r) { return r.name == base; });
    if (row == kRows.end() || modifiers.ends_with('+'))
        return std::nullopt;

    HandshakePattern pattern{std::string(name), tokens(row->initiatorPreMessage), tokens(row->responderPreMessage), {}, 0};
    for (std::string_view text = row->messages; !text.empty();)
        pattern.messages.push_back(tokens(takeUpTo(text, '|')));
    while (!modifiers.empty()) {
        if (!addPsk(pattern, takeUpTo(modifiers, '+')))
            return std::nullopt;
    }
    return pattern;
}

} // namespace skyseal::noise
