// What a client of the gateway may send besides questions: classes of messages that an operator opens by name.
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace skyseal::engine {

enum class WriteClass : std::uint8_t {
    Mission,   ///< missions, fences, rally points
    Parameter, ///< values of parameters
    Command,   ///< commands, modes, targets of position and attitude
    Ftp,       ///< files and logs
    Rc         ///< sticks and manual control
};

/// "mission", as in the option write=.
std::string_view keyword(WriteClass writeClass);
/// The class that a message belongs to; nullopt for one that no class opens.
std::optional<WriteClass> writeClassOf(std::uint32_t messageId);

class WriteRights
{
public:
    /// None.
    WriteRights() = default;
    /// Every message, those of no class and of unknown dialects as well.
    static WriteRights all();
    /// "none", "all", or names of classes separated by commas.
    static Result<WriteRights, std::string> parse(std::string_view text);

    bool mayWrite(std::uint32_t messageId) const;
    /// Whether the client may write at all. Only then its heartbeat counts as a pilot's.
    bool any() const { return m_all || m_classes != 0; }
    /// The text from which parse() makes these rights.
    std::string toText() const;

    bool operator==(const WriteRights &) const = default;

private:
    std::uint8_t m_classes = 0; ///< one bit each
    bool m_all = false;
};

} // namespace skyseal::engine
