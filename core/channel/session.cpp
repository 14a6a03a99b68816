#include "core/channel/session.h"

#include "core/channel/frame_stamp.h"

#include <algorithm>

namespace skyseal::channel {

namespace {

constexpr Duration kLeastInterval = std::chrono::seconds(1); ///< of keep-alives and of reports that are not due

/// Inline frames exist on this carrier only: the others do not carry frames unchanged, since a router or a stream splits or
/// joins them.
constexpr Carrier kInlineCarrier = Carrier::Datagram;

Permissions permissionsOf(SessionSetup &setup, const SessionContext &context)
{
    const bool inlineAgreed = setup.path.carrier == kInlineCarrier && context.traits && context.offer.allowInline
        && setup.peerOffer.allowInline;
    return Permissions(context.offer, std::move(setup.peerOffer), setup.identity.initiator, inlineAgreed);
}

} // namespace

Session::Session(SessionSetup setup, SessionContext &context, TimePoint now)
    : m_identity(std::move(setup.identity)), m_context(context), m_permissions(permissionsOf(setup, context)),
      m_epochs(std::move(setup.chain), m_identity.initiator, m_permissions.inlineAgreed()),
      m_switch(m_identity.id, m_identity.initiator, context.timing), m_rekeys(context.timing, m_identity.initiator, now),
      m_reports(now, m_identity.initiator ? now : kNever),
      m_path(setup.path, now, context.timing.peerSilentAfter, m_identity.initiator),
      m_receiver(m_epochs, opposite(m_identity.direction()), now), m_keepAlives(kLeastInterval, now),
      m_reportRequests(kLeastInterval, now), m_freshness(context.freshness, !m_identity.initiator), m_lastReceived(now)
{
    m_epochs.begin(setup.suite);
}

// ---- query

SessionInfo Session::info(TimePoint now) const
{
    SessionInfo info;
    info.session = id();
    info.peer = peer().key;
    info.peerName = peer().name;
    info.role = peer().role;
    info.path = path();
    info.suite = currentSuite();
    info.epoch = currentEpoch();
    info.framing = framing();
    info.pending = m_switch.pending();
    info.permitted = m_permissions.suites();
    info.peerOffered = m_permissions.offeredByPeer().suites;
    if (m_permissions.offeredByPeer().allowPlain)
        info.peerOffered.push_back(crypto::SuiteId::None);
    info.silent = silent(now);
    info.since = m_reports.start();
    info.lastReceived = m_lastReceived;
    return info;
}

SessionStats Session::stats() const
{
    SessionStats stats;
    stats.rx = m_epochs.received();
    stats.tx = m_epochs.sent();
    stats.epochs = m_epochs.history();
    if (!m_identity.initiator)
        stats.freshness = m_freshness.report(stats.rx.stale);
    m_reports.addTo(stats);
    return stats;
}

Framing Session::framing() const
{
    // A peer from which nothing has arrived yet cannot find the session by our address, and an agent has no proof yet that our
    // handshake is not replayed: both need a record.
    return m_confirmed && m_epochs.current().inlineWriter ? agreedFraming() : Framing::Sealed;
}

// ---- timers

TimePoint Session::retirePreviousAt() const
{
    return m_epochs.previous() ? m_handover.retireAt(m_context.timing.oldKeysLinger, roundTrip()) : kNever;
}

TimePoint Session::forgetAt() const
{
    return m_reports.provenAt() + m_context.timing.forgetAfter;
}

TimePoint Session::deadline() const
{
    if (m_finished)
        return TimePoint::min();
    return std::min({isRequestDue() ? m_lastReceived : m_reports.due(), m_switch.deadline(), forgetAt(),
                     m_leaveBy.value_or(kNever), m_closingUntil.value_or(kNever), retirePreviousAt(), m_path.deadline(),
                     knownToOwner() ? m_receiver.forgeries().deadline() : kNever});
}

void Session::handleDeadline(TimePoint now)
{
    const Timing &timing = m_context.timing;
    if (m_finished)
        return;
    if (now >= forgetAt()) {
        m_finished = DownReason::TimedOut;
        return;
    }
    if (m_leaveBy && now >= *m_leaveBy) {
        m_leaveBy.reset();
        if (!permittedHere(currentSuite())) {
            m_finished = DownReason::Closed;
            return;
        }
    }
    if (m_closingUntil && now >= *m_closingUntil) {
        m_finished = DownReason::PeerClosed;
        return;
    }
    if (now >= retirePreviousAt())
        m_epochs.retirePrevious();
    m_switch.handleDeadline(now, *this);
    if (m_rekeys.due(now, m_epochs.current().sent) && !m_switch.pending() && !silent(now)) {
        m_rekeys.started(now);
        rekey(now);
    }
    if (isRequestDue() || now >= m_reports.due()) {
        // More often until both ends have confirmed the session and know the round trip, by which a switch is timed.
        const bool settled = m_confirmed && roundTrip().settled();
        m_reports.schedule(now + (settled ? std::min(timing.statsEvery, timing.keepAliveAfter) : timing.handshakeRetry));
        sendReport(now, path(), !m_confirmed);
    }
    if (!m_path.handleDeadline(now)) {
        m_finished = DownReason::TimedOut;
        return;
    }
    notifyMove(now);
    notifyForgeries(now);
}

void Session::notifyMove(TimePoint now)
{
    if (const auto move = m_path.takeMove(now))
        notify(PeerMoved{id(), move->from, move->to});
}

void Session::notifyForgeries(TimePoint now)
{
    if (!knownToOwner())
        return;
    if (const auto counts = m_receiver.forgeries().take(now))
        notify(ForgeryAlarm{id(), counts->forged, counts->replayed});
}

void Session::end(TimePoint now, bool sendClose)
{
    m_switch.end(now, *this);
    if (sendClose)
        send(now, Close{});
}

// ---- records

// Inline: each is a call for every record otherwise.

/// Hard limit of an epoch: its counter must not wrap.
inline bool Session::exhausted(const LiveEpoch &epoch)
{
    if (epoch.sent < m_context.timing.hardStopRecords)
        return false;
    m_finished = DownReason::Exhausted;
    return true;
}

/// A record without a connection id belongs to the session that is up at the other end of the line. Control messages always
/// carry the id, so that a reconnected line finds its session again.
inline DatagramKind Session::kindFor(TimePoint now, const Path &to, ByteView plaintext) const
{
    const bool alone = to.carrier == Carrier::Serial && m_confirmed && now >= m_namedUntil;
    return alone && !isControl(plaintext) ? DatagramKind::SingleRecord : DatagramKind::Record;
}

/// Returns true if the path has not changed.
inline bool Session::follow(TimePoint now, const Path &from)
{
    if (from == path()) {
        m_path.stay(now);
        return true;
    }
    m_path.moveTo(from, now, m_reports.fullStamp(now));
    notifyMove(now);
    return false;
}

inline void Session::deliver(TimePoint now, LiveEpoch &epoch, RecordPosition position, ByteView plaintext, Delivery &delivery)
{
    const auto stamp = frameStamp(plaintext);
    const ByteView frames = stamp ? plaintext.subspan(kFrameStampLength) : plaintext;
    const Freshness freshness = m_freshness.judge({now, position, stamp, m_closingUntil.has_value()}, m_reports.peerClock());
    if (freshness == Freshness::TooOld)
        requestReport(now); // The answer tightens the bound if it was too loose.
    epoch.rx.openedBytes += frames.size();
    epoch.rx.stale += freshness != Freshness::Fresh;
    delivery.session = id();
    delivery.epoch = epoch.number;
    delivery.suite = epoch.suite;
    delivery.position = position;
    delivery.freshness = freshness;
    delivery.frames = frames;
}

Sealed Session::seal(TimePoint now, ByteView plaintext, MutableByteView out)
{
    if (isControl(plaintext))
        return SealError::NotFrames;
    if (plaintext.size() > kMaxRecordPayload)
        return SealError::TooLong;
    return m_identity.initiator ? sealStamped(now, plaintext, out) : sealRecord(now, path(), plaintext, out);
}

/// A station sends little, so that the copy costs nothing; the agent must know the age of its commands.
Sealed Session::sealStamped(TimePoint now, ByteView plaintext, MutableByteView out)
{
    std::array<std::uint8_t, kFrameStampLength + kMaxRecordPayload> stamped;
    return sealRecord(now, path(), stampFrames(m_reports.stamp(now), plaintext, stamped), out);
}

Sealed Session::sealRecord(TimePoint now, const Path &to, ByteView plaintext, MutableByteView out)
{
    LiveEpoch &epoch = m_epochs.current();
    if (exhausted(epoch))
        return SealError::Exhausted;
    constexpr std::size_t kAmple = 64; // no suite adds as much; a comparison instead of a virtual call
    if (const std::size_t least = kRecordHeaderLength + plaintext.size();
        out.size() < least + kAmple && out.size() < kRecordHeaderLength + epoch.writer->sealedSize(plaintext.size()))
        return SealError::NoRoom;

    const std::uint32_t counter = epoch.sent++;
    const RecordHeader header{kindFor(now, to, plaintext), static_cast<std::uint8_t>(epoch.number), m_identity.theirs, counter};
    const std::size_t head = header.length();
    header.write(out);
    const AssociatedData associated(header, epoch.suite, m_identity.direction(), to.carrier);
    const std::size_t sealed = epoch.writer->seal(nonceOf(counter), associated.view(), plaintext, out.subspan(head));
    if (sealed == 0)
        return SealError::NoRoom;
    ++epoch.tx.records;
    epoch.tx.sealedBytes += head + sealed;
    return head + sealed;
}

Session::Opened Session::open(TimePoint now, const Path &from, const RecordHeader &header, MutableByteView datagram,
                              std::optional<Delivery> &delivery)
{
    const auto record = m_receiver.open(header, from.carrier, datagram);
    return record ? opened(now, from, *record, delivery) : refused(now, record.error());
}

Session::Opened Session::opened(TimePoint now, const Path &from, const OpenRecord &record, std::optional<Delivery> &delivery)
{
    if (now >= forgetAt()) { // the deadline was missed while the machine slept
        m_finished = DownReason::TimedOut;
        return {false, false};
    }
    LiveEpoch &epoch = record.epoch;
    bool routine = m_confirmed && m_handover.peerMoved();
    if (m_epochs.isNext(epoch)) {
        m_switch.handleRecordUnderNext(now, *this);
        routine = false;
    }
    const bool newest = epoch.window.mark(record.counter) == ReplayWindow::Arrival::Newest;
    const RecordPosition position = positionOf(epoch.number, record.counter);
    m_freshness.addRecord(now, position);
    ++epoch.rx.good;
    epoch.rx.late += newest ? 0 : 1;
    m_lastReceived = now;
    if (!m_confirmed) {
        m_confirmed = true;
        m_reports.schedule(now);
    }
    if (&epoch == &m_epochs.current()) {
        m_handover.peerSends(now);
        // Only the newest record moves the path: a late or withheld one comes from a former address of the peer.
        if (newest)
            routine = follow(now, from) && routine;
    }
    const bool control = isControl(record.plaintext);
    if (control)
        handleControl(now, from, position, record.plaintext);
    if (m_closingUntil) {
        routine = false;
        if (!m_finished && m_epochs.nothingMissing())
            m_finished = DownReason::PeerClosed;
    }
    if (control)
        return {true, false};
    deliver(now, epoch, position, record.plaintext, delivery.emplace());
    return {true, routine};
}

Session::Opened Session::refused(TimePoint now, RecordFault fault)
{
    switch (fault) {
    case RecordFault::Replayed:
    case RecordFault::Malformed: break;
    case RecordFault::Cloned: m_finished = DownReason::Cloned; return {false, false};
    case RecordFault::Forged: notifyForgeries(now); return {false, m_receiver.forgeries().pendingForged() > 1};
    }
    return {false, true};
}

// ---- inline frames

Sealed Session::sealInline(TimePoint, ByteView frame, MutableByteView out)
{
    if (framing() != Framing::Inline)
        return SealError::NotInline;
    const auto sealable = SealableFrame::read(frame, *m_context.traits);
    if (!sealable)
        return SealError::NotInline;
    if (out.size() < sealable->sealedSize())
        return SealError::NoRoom;
    LiveEpoch &epoch = m_epochs.current();
    if (exhausted(epoch))
        return SealError::Exhausted;
    const InlinePlace place{static_cast<std::uint8_t>(epoch.number), epoch.sent++, m_identity.direction(), kInlineCarrier};
    if (!sealable->seal(place, *epoch.inlineWriter, out))
        return SealError::NoRoom;
    ++epoch.tx.records;
    epoch.tx.sealedBytes += sealable->sealedSize();
    return sealable->sealedSize();
}

Session::Opened Session::openInline(TimePoint now, const InlineFrame &frame, std::optional<Delivery> &delivery)
{
    if (!m_permissions.inlineAllowed()) {
        countMalformed();
        return {false, true};
    }
    const auto frameOpened = m_receiver.openInline(frame, kInlineCarrier);
    // Only records move the path.
    return frameOpened ? opened(now, path(), *frameOpened, delivery) : refused(now, frameOpened.error());
}

// ---- control messages

void Session::send(TimePoint now, const ControlMessage &message)
{
    sendTo(now, path(), message);
}

void Session::sendTo(TimePoint now, const Path &to, const ControlMessage &message)
{
    if (m_closingUntil)
        return;
    std::array<std::uint8_t, kMaxControl> plaintext;
    sendControl(now, to, ByteView(plaintext).first(writeControl(message, plaintext)));
}

void Session::sendControl(TimePoint now, const Path &to, ByteView plaintext)
{
    DatagramQueue::Item &draft = m_context.outgoing.draft();
    if (const auto sealed = sealRecord(now, to, plaintext, draft.bytes))
        m_context.outgoing.commit(to, *sealed);
}

void Session::sendKeepAlive(TimePoint now)
{
    // In TUNNEL, a block of padding would make this and an answer longer than the first message that causes both.
    const bool isLong = path().carrier == Carrier::Tunnel && crypto::suiteInfo(currentSuite()).blockSize > 1;
    if (!m_closingUntil && !isLong && m_keepAlives.take(now))
        sendControl(now, path(), {});
}

void Session::requestReport(TimePoint now)
{
    if (m_reportRequests.take(now)) // Otherwise the next report is soon enough.
        sendReport(now, path(), true);
}

void Session::requestReportAt(TimePoint now, const Path &to)
{
    sendReport(now, to, true);
}

void Session::handleControl(TimePoint now, const Path &from, RecordPosition position, ByteView plaintext)
{
    if (plaintext.empty())
        return; // keep-alive
    const auto message = readControl(plaintext);
    if (!message)
        return countMalformed();
    if (const auto *report = std::get_if<Report>(&*message))
        handleReport(now, from, position, *report);
    else if (std::holds_alternative<Close>(*message))
        m_closingUntil = now + std::max(roundTrip().generous(), m_context.timing.oldKeysLinger);
    else
        m_switch.handle(now, *message, *this);
}

void Session::sendReport(TimePoint now, const Path &to, bool answerAtOnce)
{
    Report report = m_reports.make(now);
    report.answerAtOnce = answerAtOnce;
    report.asksCosts = m_requestedCosts = m_context.askCosts;
    report.rx = m_epochs.received();
    report.tx = m_epochs.sent();
    if (!m_identity.initiator)
        report.freshness = m_freshness.report(report.rx.stale);
    report.cannotStore = !m_identity.initiator && !m_context.counters.problem().empty();
    report.receivesNothing = !m_identity.initiator && quiet(now);
    m_path.reportSent(to, m_reports.fullStamp(now));
    if (m_reports.peerAsksCosts() && m_context.costs)
        report.costs = m_context.costs(id());
    sendTo(now, to, report);
}

void Session::handleReport(TimePoint now, const Path &from, RecordPosition position, const Report &report)
{
    const bool wasAsked = m_reports.peerAsksCosts();
    if (m_reports.handle(now, report)) {
        m_freshness.addReport(position, report.stamp);
        if (report.echo != 0)
            m_path.confirm(from, m_reports.echo());
        m_reports.notifyChanges(id(), m_context.events);
    }
    // A peer cannot have received more than we sent, unless a copy of this end sent it: see recent_tags.h.
    if (report.rx.good > m_epochs.sent().records) {
        m_finished = DownReason::Cloned;
        m_closingUntil = now; // Nothing more may be sealed, including a Close.
    }
    // A measurement begins and ends with the answer.
    if (report.answerAtOnce || m_reports.peerAsksCosts() != wasAsked)
        sendReport(now, from, false);
}

// ---- switch

void Session::policyChanged(TimePoint now)
{
    const auto suites = m_permissions.suites();
    m_leaveBy.reset();
    if (suites.empty()) {
        m_finished = DownReason::Closed;
    } else if (!m_permissions.permits(currentSuite())) {
        // A session must not go on for ever under a suite that is not allowed any more.
        m_leaveBy = now + 2 * m_context.timing.switchConfirm;
        switchSuite(now, suites.front());
    }
}

bool Session::previousDispensable(TimePoint now) const
{
    const LiveEpoch *previous = m_epochs.previous();
    return !previous || m_handover.complete(now, previous->window.missing(), roundTrip());
}

NextEpoch Session::answerProposal(TimePoint now, const Propose &message, crypto::PublicKey &answer)
{
    if (!m_exchange.mayCompute(now))
        return NextEpoch::Ignored;
    const auto exchanged = EpochExchange::answer(message.key, m_context.random);
    if (exchanged)
        answer = exchanged->answerer;
    return prepareNext(message.suite, exchanged);
}

NextEpoch Session::prepareNext(crypto::SuiteId suite, const std::optional<SwitchSecret> &exchanged)
{
    if (!exchanged) {
        countMalformed();
        return NextEpoch::Ignored;
    }
    return m_epochs.prepareNext(suite, *exchanged) ? NextEpoch::Prepared : NextEpoch::NoCipher;
}

void Session::commitNext(TimePoint now)
{
    m_handover.epochBegan(m_epochs.current().sent);
    m_rekeys.epochBegan(now);
    m_epochs.advance();
    if (!permittedHere(currentSuite()))
        m_leaveBy = now + 2 * m_context.timing.switchConfirm; // It was agreed before the policy changed.
}

void Session::peerSentBefore(std::uint32_t records)
{
    m_epochs.expectBeforeCurrent(std::min(records, 1u << 24));
    m_handover.countReported();
}

} // namespace skyseal::channel
