#include "core/log/decode.h"

#include "core/log/log_summary.h"
#include "core/mavlink/message_json.h"
#include "core/mavlink/message_text.h"
#include "core/mavlink/signing.h"

namespace skyseal::tlog {

using mavlink::FrameFault;

namespace {

void writeJson(JsonWriter &json, const LogItem &item)
{
    json.clear();
    if (item.frame)
        mavlink::writeMessageJson(json, *item.frame, item.time);
    else
        mavlink::writeBadJson(json, item.fault, item.offset, item.length);
}

std::string textOf(const LogItem &item, const mavlink::Dialect &dialect)
{
    const std::string time = item.time ? utcText(*item.time) + " " : std::string();
    if (item.frame)
        return time + mavlink::messageText(*item.frame, dialect);
    return time + "bad: " + std::string(nameOf(item.fault)) + " at byte " + std::to_string(item.offset) + ", "
        + std::to_string(item.length) + (item.length == 1 ? " byte" : " bytes");
}

} // namespace

DecodeCounts decode(std::istream &input, const mavlink::Dialect &dialect, const DecodeOptions &options,
                    const std::function<bool(std::string_view line)> &sink)
{
    DecodeCounts counts;
    JsonWriter json;
    LogReader reader(input, dialect, options.format);
    while (auto item = reader.next()) {
        if (options.signingKey && item->frame && item->frame->isSigned()
            && !mavlink::signatureMatches(*item->frame, *options.signingKey)) {
            item->frame.reset();
            item->fault = FrameFault::BadSignature;
        }
        if (options.open && item->frame)
            item->frame = options.open(*item->frame);
        ++(item->frame ? counts.messages : counts.bad);
        bool taken = false;
        if (options.json) {
            writeJson(json, *item);
            taken = sink(json.text());
        } else {
            taken = sink(textOf(*item, dialect));
        }
        if (!taken)
            break;
    }
    return counts;
}

} // namespace skyseal::tlog
