#include "core/log/log_summary.h"

#include <algorithm>
#include <cstdio>

namespace skyseal::tlog {

using mavlink::FrameFault;

namespace {

void countFrame(LogSummary &summary, const mavlink::Frame &frame)
{
    ++summary.frames;
    summary.signedFrames += frame.isSigned();
    summary.version1Frames += frame.version() == 1;
    const std::string_view name = frame.info().name;
    auto known = summary.byMessage.find(name);
    if (known == summary.byMessage.end())
        known = summary.byMessage.emplace(std::string(name), 0).first;
    ++known->second;
    ++summary.bySender[{frame.systemId(), frame.componentId()}];
}

void countBad(LogSummary &summary, const LogItem &item)
{
    if (item.fault == FrameFault::UnknownMessage) {
        ++summary.unknownMessages;
        return;
    }
    ++summary.badSpots;
    summary.badBytes += item.length;
    if (summary.listedSpots.size() < LogSummary::kListed)
        summary.listedSpots.push_back({item.fault, item.offset, item.length});
}

void noteTime(LogSummary &summary, const LogItem &item, std::chrono::microseconds pause)
{
    const WallTime time = *item.time, previous = summary.last.value_or(time);
    if (!summary.first)
        summary.first = time;
    summary.last = time;
    if (time >= previous && time - previous <= pause)
        return;
    ++(time < previous                               ? summary.backwardSteps
           : time - previous > LogTime::kLongestStep ? summary.forwardSteps
                                                     : summary.pauses);
    if (summary.listedGaps.size() < LogSummary::kListed)
        summary.listedGaps.push_back({item.offset, previous, time});
}

} // namespace

LogSummary summarize(std::istream &input, const mavlink::Dialect &dialect, std::chrono::microseconds pause)
{
    LogSummary summary;
    LogReader reader(input, dialect);
    LogTime line;
    while (const auto item = reader.next()) {
        if (item->frame)
            countFrame(summary, *item->frame);
        else
            countBad(summary, *item);
        if (item->time)
            noteTime(summary, *item, pause);
        summary.length = line.note(item->time);
    }
    summary.format = reader.format();
    summary.bytes = reader.bytesRead();
    return summary;
}

void writeSummaryFields(JsonWriter &json, const LogSummary &summary)
{
    json.field("format", summary.format == LogFormat::Tlog ? "tlog" : "raw").field("bytes", summary.bytes);
    json.field("frames", summary.frames).field("signed", summary.signedFrames).field("version1", summary.version1Frames);
    json.field("unknown_messages", summary.unknownMessages).field("bad_spots", summary.badSpots);
    json.field("bad_bytes", summary.badBytes).field("pauses", summary.pauses).field("backward_steps", summary.backwardSteps);
    json.field("forward_steps", summary.forwardSteps);
    if (summary.first) {
        json.field("first", std::string_view(utcText(*summary.first))).field("last", std::string_view(utcText(*summary.last)));
        json.field("seconds", std::chrono::duration<double>(summary.length).count());
    }
    json.key("messages").beginObject();
    for (const auto &[name, count] : summary.byMessage)
        json.field(name, count);
    json.endObject().key("senders").beginArray();
    for (const auto &[sender, count] : summary.bySender) {
        json.beginObject().field("sysid", std::uint32_t(sender.first)).field("compid", std::uint32_t(sender.second));
        json.field("frames", count).endObject();
    }
    json.endArray().key("bad").beginArray();
    for (const BadSpot &spot : summary.listedSpots) {
        json.beginObject().field("reason", nameOf(spot.fault)).field("offset", spot.offset).field("length", spot.length);
        json.endObject();
    }
    json.endArray().key("gaps").beginArray();
    for (const TimeGap &gap : summary.listedGaps) {
        json.beginObject().field("offset", gap.offset).field("before", std::string_view(utcText(gap.before)));
        json.field("after", std::string_view(utcText(gap.after))).endObject();
    }
    json.endArray();
}

std::string utcText(WallTime time)
{
    using namespace std::chrono;
    const auto day = floor<days>(time);
    const year_month_day date(day);
    const auto since = duration_cast<microseconds>(time - day).count();
    char text[48];
    std::snprintf(text, sizeof text, "%04d-%02u-%02uT%02d:%02d:%02d.%06dZ", static_cast<int>(date.year()),
                  static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                  static_cast<int>(since / 3'600'000'000), static_cast<int>(since / 60'000'000 % 60),
                  static_cast<int>(since / 1'000'000 % 60), static_cast<int>(since % 1'000'000));
    return text;
}

} // namespace skyseal::tlog
