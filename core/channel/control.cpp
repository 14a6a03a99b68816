#include "core/channel/control.h"

#include "core/base/byte_reader.h"
#include "core/base/byte_writer.h"

namespace skyseal::channel {

namespace {

enum class Type : std::uint8_t { Propose = 1, Accept = 2, Refuse = 3, Confirm = 4, Confirmed = 5, Report = 6, Close = 7 };

// Flags of a report.
constexpr std::uint8_t kAnswerAtOnce = 1, kCountsFrames = 2, kAsksCosts = 4, kTellsCosts = 8, kTellsFreshness = 16,
                       kCannotStore = 32, kReceivesNothing = 64;
constexpr std::uint8_t kReportFlags = kAnswerAtOnce | kCountsFrames | kAsksCosts | kTellsCosts | kTellsFreshness | kCannotStore
    | kReceivesNothing;

// The order of the counters on the wire.
constexpr std::uint64_t ReceiveCounters::*kReceived[] = {&ReceiveCounters::good,
                                                         &ReceiveCounters::late,
                                                         &ReceiveCounters::lost,
                                                         &ReceiveCounters::replayed,
                                                         &ReceiveCounters::forged,
                                                         &ReceiveCounters::malformed,
                                                         &ReceiveCounters::plaintextDropped,
                                                         &ReceiveCounters::openedBytes};
constexpr std::uint64_t SendCounters::*kSent[] = {&SendCounters::records, &SendCounters::sealedBytes};
constexpr std::uint64_t FrameCounters::*kFrames[] = {&FrameCounters::taken, &FrameCounters::lost};
constexpr std::uint64_t FreshnessReport::*kFreshness[] = {&FreshnessReport::stale, &FreshnessReport::ageMicroseconds,
                                                          &FreshnessReport::overtakenMilliseconds,
                                                          &FreshnessReport::limitMilliseconds};
constexpr std::uint64_t EndCosts::*kCosts[] = {&EndCosts::cpuMicroseconds, &EndCosts::residentBytes,
                                               &EndCosts::opened,          &EndCosts::openNanoseconds,
                                               &EndCosts::sealed,          &EndCosts::sealNanoseconds};

// LEB128: counters are small for most of a flight, and a report is sent every second.
void writeVarint(ByteWriter &out, std::uint64_t value)
{
    for (; value >= 0x80; value >>= 7)
        out.u8(static_cast<std::uint8_t>(value | 0x80));
    out.u8(static_cast<std::uint8_t>(value));
}

std::optional<std::uint64_t> readVarint(ByteReader &in)
{
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64; shift += 7) {
        const std::uint8_t byte = in.u8();
        if (shift == 63 && byte > 1)
            return std::nullopt;
        value |= std::uint64_t{byte & 0x7fu} << shift;
        if (byte < 0x80)
            return value;
    }
    return std::nullopt;
}

template<typename Group, std::size_t size>
void writeGroup(ByteWriter &out, const Group &group, std::uint64_t Group::*const (&numbers)[size])
{
    for (const auto number : numbers)
        writeVarint(out, group.*number);
}

template<typename Group, std::size_t size>
bool readGroup(ByteReader &in, Group &group, std::uint64_t Group::*const (&numbers)[size])
{
    for (const auto number : numbers) {
        const auto value = readVarint(in);
        if (!value)
            return false;
        group.*number = *value;
    }
    return true;
}

std::uint8_t flagsOf(const Report &report)
{
    return static_cast<std::uint8_t>((report.answerAtOnce ? kAnswerAtOnce : 0) | (report.frames ? kCountsFrames : 0)
                                     | (report.asksCosts ? kAsksCosts : 0) | (report.costs ? kTellsCosts : 0)
                                     | (report.freshness ? kTellsFreshness : 0) | (report.cannotStore ? kCannotStore : 0)
                                     | (report.receivesNothing ? kReceivesNothing : 0));
}

struct Writer
{
    ByteWriter &out;

    void type(Type t) const { out.u8(static_cast<std::uint8_t>(t)); }
    void id(ProposalId value) const { out.u32(static_cast<std::uint32_t>(value)); }
    void epoch(Epoch value) const { out.u32(static_cast<std::uint32_t>(value)); }

    void operator()(const Propose &m) const
    {
        type(Type::Propose);
        id(m.id);
        epoch(m.epoch);
        out.u8(static_cast<std::uint8_t>(m.suite));
        out.bytes(m.key);
    }
    void operator()(const Accept &m) const
    {
        type(Type::Accept);
        id(m.id);
        out.bytes(m.key);
    }
    void operator()(const Refuse &m) const
    {
        type(Type::Refuse);
        id(m.id);
    }
    void operator()(const Confirm &m) const
    {
        type(Type::Confirm);
        epoch(m.epoch);
        out.u32(m.sentBefore);
    }
    void operator()(const Confirmed &m) const
    {
        type(Type::Confirmed);
        epoch(m.epoch);
        out.u32(m.sentBefore);
    }
    void operator()(const Report &m) const
    {
        type(Type::Report);
        out.u8(flagsOf(m));
        out.u32(m.stamp);
        out.u32(m.echo);
        out.u32(m.held);
        writeGroup(out, m.rx, kReceived);
        writeGroup(out, m.tx, kSent);
        if (m.frames)
            writeGroup(out, *m.frames, kFrames);
        if (m.freshness)
            writeGroup(out, *m.freshness, kFreshness);
        if (m.costs)
            writeGroup(out, *m.costs, kCosts);
    }
    void operator()(const Close &) const { type(Type::Close); }
};

void readKey(ByteReader &in, crypto::PublicKey &key)
{
    const ByteView raw = in.bytes(key.size());
    std::copy(raw.begin(), raw.end(), key.begin());
}

std::optional<Report> readReport(ByteReader &in)
{
    Report report;
    const std::uint8_t flags = in.u8();
    if ((flags & ~kReportFlags) != 0)
        return std::nullopt;
    report.answerAtOnce = (flags & kAnswerAtOnce) != 0;
    report.asksCosts = (flags & kAsksCosts) != 0;
    report.cannotStore = (flags & kCannotStore) != 0;
    report.receivesNothing = (flags & kReceivesNothing) != 0;
    report.stamp = in.u32();
    report.echo = in.u32();
    report.held = in.u32();
    if (!readGroup(in, report.rx, kReceived) || !readGroup(in, report.tx, kSent))
        return std::nullopt;
    if ((flags & kCountsFrames) != 0 && !readGroup(in, report.frames.emplace(), kFrames))
        return std::nullopt;
    if ((flags & kTellsFreshness) != 0 && !readGroup(in, report.freshness.emplace(), kFreshness))
        return std::nullopt;
    if ((flags & kTellsCosts) != 0 && !readGroup(in, report.costs.emplace(), kCosts))
        return std::nullopt;
    return report;
}

std::optional<ControlMessage> readBody(Type type, ByteReader &in)
{
    switch (type) {
    case Type::Propose: {
        Propose m;
        m.id = ProposalId{in.u32()};
        m.epoch = Epoch{in.u32()};
        const auto suite = crypto::suiteFromNumber(in.u8());
        readKey(in, m.key);
        if (!suite)
            return std::nullopt;
        m.suite = *suite;
        return m;
    }
    case Type::Accept: {
        Accept m;
        m.id = ProposalId{in.u32()};
        readKey(in, m.key);
        return m;
    }
    case Type::Refuse: return Refuse{ProposalId{in.u32()}};
    case Type::Confirm: {
        const Epoch epoch{in.u32()};
        return Confirm{epoch, in.u32()};
    }
    case Type::Confirmed: {
        const Epoch epoch{in.u32()};
        return Confirmed{epoch, in.u32()};
    }
    case Type::Report:
        if (const auto report = readReport(in))
            return *report;
        return std::nullopt;
    case Type::Close: return Close{};
    }
    return std::nullopt;
}

} // namespace

std::size_t writeControl(const ControlMessage &message, MutableByteView out)
{
    ByteWriter writer(out);
    std::visit(Writer{writer}, message);
    return writer.ok() ? writer.size() : 0;
}

std::optional<ControlMessage> readControl(ByteView plaintext)
{
    ByteReader in(plaintext);
    const auto type = static_cast<Type>(in.u8());
    auto message = readBody(type, in);
    if (!message || !in.ok() || !in.atEnd())
        return std::nullopt;
    return message;
}

} // namespace skyseal::channel
