#include "core/channel/epochs.h"

#include "core/channel/counter_sums.h"

namespace skyseal::channel {

namespace {

constexpr std::size_t kHistory = 16;

} // namespace

EpochStats LiveEpoch::stats() const
{
    EpochStats out{number, suite, rx, tx};
    out.rx.lost = window.missing();
    return out;
}

LiveEpoch *Epochs::byLowByte(std::uint8_t lowByte)
{
    LiveEpoch *const epoch = byBits(lowByte & 3);
    return epoch && static_cast<std::uint8_t>(epoch->number) == lowByte ? epoch : nullptr;
}

void Epochs::begin(crypto::SuiteId suite)
{
    if (install(Epoch{0}, suite, m_chain.begin(suite)))
        advance();
}

bool Epochs::prepareNext(crypto::SuiteId suite, const SwitchSecret &exchanged)
{
    const Epoch number{static_cast<std::uint32_t>(m_current->number) + 1};
    return install(number, suite, m_chain.advance(number, suite, exchanged));
}

bool Epochs::install(Epoch number, crypto::SuiteId suite, EpochSecrets secrets)
{
    LiveEpoch epoch;
    epoch.number = number;
    epoch.suite = suite;
    Key32 &ours = m_initiator ? secrets.fromInitiator : secrets.fromResponder;
    Key32 &theirs = m_initiator ? secrets.fromResponder : secrets.fromInitiator;
    if (m_withInline) {
        epoch.inlineWriter = crypto::makeInlineCipher(suite, ours);
        epoch.inlineReader = crypto::makeInlineCipher(suite, theirs);
    }
    epoch.writer = crypto::makeRecordCipher(suite, std::move(ours));
    epoch.reader = crypto::makeRecordCipher(suite, std::move(theirs));
    if (!epoch.writer || !epoch.reader)
        return false;
    m_chainAfterNext = std::move(secrets.next);
    m_next = std::make_unique<LiveEpoch>(std::move(epoch));
    return true;
}

void Epochs::dropNext()
{
    m_next.reset();
    m_chainAfterNext.reset();
}

void Epochs::advance()
{
    retirePrevious();
    m_previous = std::move(m_current);
    if (m_previous)
        m_previous->writer.reset(), m_previous->inlineWriter.reset();
    m_current = std::move(m_next);
    m_chain = std::move(*m_chainAfterNext);
    m_chainAfterNext.reset();
}

void Epochs::retirePrevious()
{
    if (!m_previous)
        return;
    if (m_last) {
        add(m_receivedBefore, m_last->stats.rx);
        add(m_sentBefore, m_last->stats.tx);
        m_history.push_back(m_last->stats);
        if (m_history.size() > kHistory)
            m_history.pop_front();
    }
    m_last = Retired{m_previous->stats(), m_previous->window};
    m_previous.reset();
}

void Epochs::expectBeforeCurrent(std::uint32_t records)
{
    if (m_previous) {
        m_previous->window.expect(records);
    } else if (m_last) {
        m_last->window.expect(records);
        m_last->stats.rx.lost = m_last->window.missing();
    }
}

bool Epochs::nothingMissing() const
{
    return m_current->window.missing() == 0 && (!m_previous || m_previous->window.missing() == 0);
}

ReceiveCounters Epochs::received() const
{
    ReceiveCounters sum = m_receivedBefore;
    if (m_last)
        add(sum, m_last->stats.rx);
    if (m_previous)
        add(sum, m_previous->stats().rx);
    add(sum, m_current->stats().rx);
    return sum;
}

SendCounters Epochs::sent() const
{
    SendCounters sum = m_sentBefore;
    if (m_last)
        add(sum, m_last->stats.tx);
    if (m_previous)
        add(sum, m_previous->tx);
    add(sum, m_current->tx);
    return sum;
}

std::vector<EpochStats> Epochs::history() const
{
    std::vector<EpochStats> out(m_history.begin(), m_history.end());
    if (m_last)
        out.push_back(m_last->stats);
    if (m_previous)
        out.push_back(m_previous->stats());
    out.push_back(m_current->stats());
    if (out.size() > kHistory)
        out.erase(out.begin(), out.end() - kHistory);
    return out;
}

} // namespace skyseal::channel
