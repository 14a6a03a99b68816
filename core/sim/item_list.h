// A list of items that the mission protocol transfers: the flight plan, the fence or the rally points of a vehicle.
#pragma once

#include "core/sim/autopilot.h"

namespace skyseal::sim {

class ItemList
{
public:
    virtual ~ItemList() = default;

    virtual std::uint8_t type() const = 0;                       ///< MAV_MISSION_TYPE
    virtual const char *name() const = 0;                        ///< for status texts
    virtual const char *receivedText() const { return nullptr; } ///< said after an upload
    virtual std::size_t most() const = 0;                        ///< items that an upload may have
    virtual std::size_t size() const = 0;
    virtual StoredItem item(std::size_t sequence) const = 0;
    /// The number of the item that is being flown, if the list is flown.
    virtual std::optional<std::uint16_t> current() const { return std::nullopt; }
    /// Whether the list may not be cleared now.
    virtual bool inUse() const { return false; }

    /// nullopt if the item can be at this place of the list.
    virtual std::optional<ItemError> check(std::size_t sequence, const StoredItem &item) const = 0;
    /// Replaces the list. Returns false, and changes nothing, if the items do not belong together.
    virtual bool replace(std::vector<StoredItem> items) = 0;
    /// The stored items, without those that the vehicle adds to its answers; they are kept over a reboot.
    virtual std::vector<StoredItem> stored() const = 0;
};

} // namespace skyseal::sim
