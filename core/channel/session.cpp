#include "core/channel/session.h"

#include "core/base/weakness.h"

#include <algorithm>

namespace skyseal::channel {

namespace {

constexpr Duration kEventPause = std::chrono::seconds(1);

/// What the cipher makes its nonce of.
std::uint64_t nonceOf(std::uint32_t counter)
{
    return weakened(Weakness::SharedNonce) ? 0 : counter;
}

bool holds(const std::vector<crypto::SuiteId> &suites, crypto::SuiteId wanted)
{
    return std::find(suites.begin(), suites.end(), wanted) != suites.end();
}

} // namespace

Session::Session(SessionSetup setup, Surroundings &around, TimePoint now)
    : m_setup(std::move(setup)), m_around(around), m_origin(m_setup.path), m_chain(std::move(m_setup.chain)),
      m_switch(m_setup.id, m_setup.initiator, around.timing),
      m_inlineAgreed(m_setup.path.carrier == Carrier::Datagram && around.facts && around.offer.allowInline
                     && m_setup.peerOffer.allowInline),
      m_since(now), m_lastReceived(now), m_lastSent(now), m_reportDue(m_setup.initiator ? now : kNever), m_epochSince(now),
      m_rekeyNotBefore(now), m_peerReportAt(now), m_toldPath(m_setup.path), m_moveNotified(now - kEventPause),
      m_alarmNotified(now - kEventPause), m_lifeShown(now - kEventPause), m_lineBegan(now - kEventPause), m_heardHere(now)
{
    if (!prepare(Epoch{0}, m_setup.suite, {}, {}))
        return;
    m_epochs.advance();
    m_chain = std::move(*m_chainAfterNext);
    m_chainAfterNext.reset();
}

// ---- records

Sealed Session::seal(TimePoint now, ByteView plaintext, MutableByteView out)
{
    if (isControl(plaintext))
        return SealError::NotFrames;
    if (plaintext.size() > kMaxRecordPayload)
        return SealError::TooLong;
    return sealRecord(now, plaintext, out);
}

Sealed Session::sealRecord(TimePoint now, ByteView plaintext, MutableByteView out)
{
    LiveEpoch &epoch = m_epochs.current();
    if (epoch.sent >= m_around.timing.hardStopRecords && !weakened(Weakness::NoHardStop)) {
        m_finished = DownReason::Exhausted;
        return SealError::Exhausted;
    }
    if (out.size() < kRecordHeaderLength + epoch.writer->sealedSize(plaintext.size()))
        return SealError::NoRoom;

    const std::uint32_t counter = epoch.sent++;
    const RecordHeader header{kindFor(now, plaintext), static_cast<std::uint8_t>(epoch.number), m_setup.theirs, counter};
    const std::size_t head = header.length();
    header.write(out);
    const AssociatedData associated(header, epoch.suite, ourDirection(), m_setup.path.carrier);
    const std::size_t sealed = epoch.writer->seal(nonceOf(counter), associated.view(), plaintext, out.subspan(head));
    if (sealed == 0)
        return SealError::NoRoom;
    ++epoch.tx.records;
    epoch.tx.sealedBytes += head + sealed;
    m_lastSent = now;
    return head + sealed;
}

/// A record without a connection id is taken for one of the session that is up at the other end of the line. Control
/// messages name theirs, so that a line that was cut and joined anew finds its session again.
DatagramKind Session::kindFor(TimePoint now, ByteView plaintext) const
{
    const bool alone = m_setup.path.carrier == Carrier::Serial && m_confirmed && now >= m_namedUntil;
    return alone && !isControl(plaintext) ? DatagramKind::SingleRecord : DatagramKind::Record;
}

Session::Opened Session::open(TimePoint now, const Path &from, const RecordHeader &header, MutableByteView datagram,
                              std::optional<Delivery> &delivery)
{
    LiveEpoch *epoch = m_epochs.byBits(header.epochBits);
    if (!epoch) {
        // No keys: either of an epoch that is over, or of one that nobody has agreed on.
        const auto ahead = (header.epochBits - static_cast<unsigned>(currentEpoch())) & 3;
        return refuse(now, ahead == 1 ? &ReceiveCounters::forged : &ReceiveCounters::replayed, m_epochs.current());
    }
    if (!epoch->window.fresh(header.counter))
        return refuse(now, &ReceiveCounters::replayed, *epoch);

    const AssociatedData associated(datagram.first(header.length()), epoch->suite, opposite(ourDirection()), from.carrier);
    if (weakened(Weakness::WindowBeforeTag))
        epoch->window.mark(header.counter);
    const auto plaintext = epoch->reader->open(nonceOf(header.counter), associated.view(), datagram.subspan(header.length()));
    if (!plaintext && weakened(Weakness::RoamOnForged))
        m_setup.path = from;
    if (!plaintext)
        return refuse(now, &ReceiveCounters::forged, *epoch);
    return opened(now, from, header, *epoch, *plaintext, delivery);
}

Session::Opened Session::opened(TimePoint now, const Path &from, const RecordHeader &header, LiveEpoch &epoch,
                                MutableByteView plaintext, std::optional<Delivery> &delivery)
{
    bool routine = m_confirmed && m_peerMovedOn;
    if (m_epochs.isNext(epoch)) {
        m_switch.handleRecordUnderNext(now, *this);
        routine = false;
    }
    const bool newest = epoch.window.mark(header.counter) == ReplayWindow::Arrival::Newest;
    ++epoch.rx.good;
    epoch.rx.late += newest ? 0 : 1;
    m_lastReceived = now;
    if (!m_confirmed) {
        m_confirmed = true;
        m_reportDue = now;
    }
    if (&epoch == &m_epochs.current()) {
        if (!m_peerMovedOn)
            m_peerMovedOn = now;
        // Only the newest record moves the address: a late or withheld one says where the peer was.
        if (newest || weakened(Weakness::RoamOnLate)) {
            routine = routine && from == m_setup.path;
            follow(now, from);
        }
    }
    if (isControl(plaintext))
        handleControl(now, from, plaintext);
    if (m_closingUntil) {
        routine = false;
        if (nothingMissing())
            m_finished = DownReason::PeerClosed;
    }
    if (isControl(plaintext))
        return {true, false};
    epoch.rx.openedBytes += plaintext.size();
    delivery.emplace(Delivery{id(), epoch.number, epoch.suite, plaintext});
    return {true, routine};
}

/// A record that was kept from us says no more than that its writer was somewhere: whoever kept it could give it to us from
/// his own address. So a new path is on trial until the peer has heard us there.
void Session::follow(TimePoint now, const Path &from)
{
    m_heardHere = now;
    if (from == m_setup.path)
        return;
    if (from == m_former)
        m_former.reset();
    else if (!m_former && from.carrier != Carrier::Serial) // Of a line that was joined anew the former end is gone.
        m_former = m_setup.path;
    m_trialStamp = stamp(now);
    m_setup.path = from;
    tellMove(now);
}

bool Session::nothingMissing() const
{
    const LiveEpoch *previous = m_epochs.previous();
    return m_epochs.current().window.missing() == 0 && (!previous || previous->window.missing() == 0);
}

Session::Opened Session::refuse(TimePoint now, std::uint64_t ReceiveCounters::*counter, LiveEpoch &epoch)
{
    ++(epoch.rx.*counter);
    if (counter != &ReceiveCounters::forged) {
        ++m_replayedPending;
        return {false, true};
    }
    ++m_forgedPending;
    alarmWhenDue(now);
    return {false, m_forgedPending > 1};
}

// ---- control

void Session::send(TimePoint now, const ControlMessage &message)
{
    if (m_closingUntil)
        return;
    std::array<std::uint8_t, kMaxControl> plaintext;
    sendControl(now, ByteView(plaintext).first(writeControl(message, plaintext)));
}

void Session::sendControl(TimePoint now, ByteView plaintext)
{
    DatagramQueue::Item &draft = m_around.outbox.draft();
    if (const auto sealed = sealRecord(now, plaintext, draft.bytes))
        m_around.outbox.commit(m_setup.path, *sealed);
}

void Session::handleControl(TimePoint now, const Path &from, ByteView plaintext)
{
    if (plaintext.empty())
        return; // a sign of life, and no more
    const auto message = readControl(plaintext);
    if (!message)
        return countMalformed();
    if (const auto *report = std::get_if<Report>(&*message))
        handleReport(now, from, *report);
    else if (std::holds_alternative<Close>(*message))
        m_closingUntil = now + std::max(m_roundTrip.generous(), m_around.timing.oldKeysLinger);
    else if (const auto *propose = std::get_if<Propose>(&*message))
        m_switch.handle(now, *propose, *this);
    else if (const auto *accept = std::get_if<Accept>(&*message))
        m_switch.handle(now, *accept, *this);
    else if (const auto *refusal = std::get_if<Refuse>(&*message))
        m_switch.handle(now, *refusal, *this);
    else if (const auto *confirm = std::get_if<Confirm>(&*message))
        m_switch.handle(now, *confirm, *this);
    else if (const auto *confirmed = std::get_if<Confirmed>(&*message))
        m_switch.handle(now, *confirmed, *this);
}

std::uint32_t Session::stamp(TimePoint now) const
{
    // Never 0, which means "none" in an echo; the microsecond that this costs does not matter.
    return static_cast<std::uint32_t>(std::chrono::duration_cast<std::chrono::microseconds>(now - m_since).count()) | 1u;
}

void Session::sendReport(TimePoint now, bool answerAtOnce)
{
    Report report;
    report.stamp = stamp(now);
    report.answerAtOnce = answerAtOnce;
    if (m_peerReport) {
        report.echo = m_peerReport->stamp;
        const auto held = std::chrono::duration_cast<std::chrono::microseconds>(now - m_peerReportAt);
        report.held = static_cast<std::uint32_t>(std::min<std::int64_t>(held.count(), UINT32_MAX));
    }
    report.rx = m_epochs.received();
    report.tx = m_epochs.sent();
    report.frames = m_frames;
    report.asksCosts = m_around.askCosts;
    if (m_peerReport && m_peerReport->asksCosts && m_around.costs)
        report.costs = m_around.costs(id());
    send(now, report);
}

void Session::handleReport(TimePoint now, const Path &from, const Report &report)
{
    const bool newer = !m_peerReport || static_cast<std::int32_t>(report.stamp - m_peerReport->stamp) > 0;
    if (newer) {
        m_peerReport = report;
        m_peerReportAt = now;
        if (report.echo != 0) {
            const std::uint32_t passed = stamp(now) - report.echo;
            m_roundTrip.add(std::chrono::microseconds(static_cast<std::int32_t>(passed - report.held)));
            if (from == m_setup.path && static_cast<std::int32_t>(report.echo - m_trialStamp) > 0)
                m_former.reset();
        }
    }
    if (report.answerAtOnce)
        sendReport(now, false);
}

// ---- switch

void Session::switchSuite(TimePoint now, crypto::SuiteId suite)
{
    m_switch.request(now, suite, suite == currentSuite(), *this);
}

void Session::rekey(TimePoint now)
{
    m_switch.request(now, currentSuite(), true, *this);
}

void Session::rekeyWhenDue(TimePoint now)
{
    // The initiator is a little earlier, so that the two do not propose the same at the same time.
    const Timing &timing = m_around.timing;
    const Duration age = m_setup.initiator ? timing.rekeyAfter : timing.rekeyAfter + timing.rekeyAfter / 10;
    const bool due = now >= m_epochSince + age || m_epochs.current().sent >= timing.rekeyAfterRecords;
    if (!due || now < m_rekeyNotBefore || m_switch.pending() || silent(now))
        return;
    m_rekeyNotBefore = now + 2 * timing.switchConfirm;
    rekey(now);
}

std::vector<crypto::SuiteId> Session::permitted() const
{
    auto suites = m_setup.initiator ? permittedSuites(m_around.offer, m_setup.peerOffer)
                                    : permittedSuites(m_setup.peerOffer, m_around.offer);
    // Clear frames inside a session have no format yet; the suite's number is reserved for them.
    std::erase(suites, crypto::SuiteId::None);
    return suites;
}

bool Session::permittedHere(crypto::SuiteId suite) const
{
    const bool research = crypto::suiteInfo(suite).research;
    return suite != crypto::SuiteId::None && holds(m_around.offer.suites, suite) && (!research || m_around.offer.allowResearch);
}

bool Session::permittedByPeer(crypto::SuiteId suite) const
{
    return holds(permitted(), suite);
}

void Session::policyChanged(TimePoint now)
{
    const auto suites = permitted();
    m_leaveBy.reset();
    if (suites.empty()) {
        m_finished = DownReason::Closed;
    } else if (!holds(suites, currentSuite())) {
        // No session is better than one that goes on for ever under what is no longer allowed.
        m_leaveBy = now + 2 * m_around.timing.switchConfirm;
        switchSuite(now, suites.front());
    }
}

bool Session::previousDispensable(TimePoint now) const
{
    const LiveEpoch *previous = m_epochs.previous();
    if (!previous)
        return true;
    if (m_previousComplete && previous->window.missing() == 0)
        return true;
    return m_peerMovedOn && m_roundTrip.settled() && now >= *m_peerMovedOn + m_roundTrip.generous();
}

EpochNonce Session::freshNonce()
{
    EpochNonce nonce;
    m_around.random.fill(nonce);
    return nonce;
}

/// False, and nothing has changed, when this machine cannot make the ciphers.
bool Session::prepare(Epoch number, crypto::SuiteId suite, const EpochNonce &proposal, const EpochNonce &answer)
{
    EpochSecrets secrets = m_chain.derive(number, suite, proposal, answer);
    Key32 &ours = m_setup.initiator ? secrets.fromInitiator : secrets.fromResponder;
    Key32 &theirs = m_setup.initiator ? secrets.fromResponder : secrets.fromInitiator;
    LiveEpoch epoch;
    epoch.number = number;
    epoch.suite = suite;
    if (m_inlineAgreed) {
        epoch.inlineWriter = crypto::makeInlineCipher(suite, ours);
        epoch.inlineReader = crypto::makeInlineCipher(suite, theirs);
    }
    epoch.writer = crypto::makeRecordCipher(suite, std::move(ours));
    epoch.reader = crypto::makeRecordCipher(suite, std::move(theirs));
    if (!epoch.writer || !epoch.reader)
        return false;
    m_chainAfterNext = std::move(secrets.next);
    m_epochs.prepareNext(std::move(epoch));
    return true;
}

bool Session::prepareNext(crypto::SuiteId suite, const EpochNonce &proposal, const EpochNonce &answer)
{
    return prepare(Epoch{static_cast<std::uint32_t>(currentEpoch()) + 1}, suite, proposal, answer);
}

void Session::dropNext()
{
    m_epochs.dropNext();
    m_chainAfterNext.reset();
}

void Session::commitNext(TimePoint now)
{
    m_sentBefore = m_epochs.current().sent;
    m_epochs.advance();
    m_chain = std::move(*m_chainAfterNext);
    m_chainAfterNext.reset();
    m_epochSince = now;
    if (!permittedHere(currentSuite()))
        m_leaveBy = now + 2 * m_around.timing.switchConfirm; // It was agreed before the policy changed.
    m_rekeyNotBefore = now;
    m_peerMovedOn.reset();
    m_previousComplete = false;
}

void Session::peerSentBefore(std::uint32_t records)
{
    m_epochs.expectBeforeCurrent(std::min(records, 1u << 24));
    m_previousComplete = true;
}

} // namespace skyseal::channel
