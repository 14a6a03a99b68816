// Messages that a client of the gateway may send besides questions (read-only requests): classes that an operator permits by
// name.
#pragma once

#include "core/base/result.h"
#include "core/mavlink/frame_scanner.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace skyseal::engine {

enum class WriteClass : std::uint8_t {
    Mission,   ///< missions, fences, rally points; not the choice of the item to fly next
    Parameter, ///< values of parameters
    Command,   ///< commands, modes, targets of position and attitude
    Ftp,       ///< files and logs
    Rc         ///< sticks and manual control
};

/// "mission", as in the option write=.
std::string_view keyword(WriteClass writeClass);
/// The class of a message, a whole one from a scanner; nullopt for one that is in no class.
std::optional<WriteClass> writeClassOf(const mavlink::ScanItem &item);

class WriteRights
{
public:
    /// None.
    WriteRights() = default;
    /// Every message, including those of no class and of unknown dialects.
    static WriteRights all();
    /// "none", "all", or names of classes separated by commas.
    static Result<WriteRights, Reason> parse(std::string_view text);

    bool mayWrite(const mavlink::ScanItem &item) const;
    /// Whether the client may write at all. Only then its heartbeat is forwarded.
    bool any() const { return m_all || m_classes != 0; }
    /// Text that parse() reads back to these rights.
    std::string toText() const;

    bool operator==(const WriteRights &) const = default;

private:
    std::uint8_t m_classes = 0; ///< one bit each
    bool m_all = false;
};

} // namespace skyseal::engine
