// The JSON that the station's monitor and the agent share: one object a line for links and storage, and the parts of their
// statistics. Names and shapes are part of the programs' interface.
#pragma once

#include "core/base/json_writer.h"
#include "core/channel/events.h"
#include "core/engine/common/link_snapshot.h"
#include "core/engine/common/storage_watch.h"
#include "core/engine/common/totals.h"

#include <string>
#include <string_view>

namespace skyseal::engine {

/// Begins an object with its "event"; endEvent() closes it and returns the line.
JsonWriter beginEvent(std::string_view event);
std::string endEvent(JsonWriter &json);

/// `side` is "vehicle" or "ground" for programs with two sides; empty otherwise.
std::string linkEvent(const LinkSnapshot &link, std::string_view side = {});
/// {"event":"counter_storage","works":…}, with a "problem" if storing fails.
std::string counterStorageEvent(const CounterStorage &storage);

/// Parts of "stats" and "summary".
void writeMavlink(JsonWriter &json, const MavlinkTotals &totals);
void writeChannel(JsonWriter &json, const ChannelTotals &totals);
/// Fields of the object that is open: "age_ms" (null if unknown), "overtaken_limit_ms", "age_limit_ms" (0: none).
void writeFreshness(JsonWriter &json, const channel::FreshnessReport &report);
void writeProcess(JsonWriter &json, double cpuPercent, std::uint64_t residentBytes);

} // namespace skyseal::engine
