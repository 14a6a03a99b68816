// The link that a sweep measures, as the station's snapshots show it: how it carries MAVLink, which session and which vehicles
// count in that mode, and what the far end allows. Holds no station and sends nothing. Plain object without a thread.
#pragma once

#include "core/base/reason.h"
#include "core/channel/events.h"
#include "core/engine/station/protection.h"
#include "core/experiment/plan.h"

#include <optional>

namespace skyseal::engine {
struct Snapshot;
struct SessionSnapshot;
struct VehicleSnapshot;
} // namespace skyseal::engine

namespace skyseal::experiment {

/// How the link carries MAVLink in a run of this arm.
engine::Protection protectionOf(const SweepArm &arm);

class MeasuredLink
{
public:
    /// Problem of a run under a bare cipher whose vehicle uses another key.
    static constexpr Sentence kUnreadable = sentence("Reason",
                                                     "the vehicle's payloads could not be decrypted; is its key another one?");

    /// A station was opened. Knowledge about the far end is kept.
    void stationOpened();
    /// Notes the protection that the station is ordered to use; nullopt: that of its settings. A session that ends because of
    /// the change is ignored from this call on. `snapshot`: the newest one, null before the first.
    void setProtection(std::optional<engine::Protection> protection, const engine::Snapshot *snapshot);
    /// Notes the cipher by which the vehicle is ordered to encrypt payloads in plain MAVLink; nullopt: by none. setProtection()
    /// ends it as well.
    void setBareCipher(std::optional<crypto::MavsecKind> cipher, const engine::Snapshot *snapshot);
    void sessionUp(const channel::SessionUp &up) { m_framing = up.framing; }
    /// Remembers the suite of the first session.
    void update(const engine::Snapshot &snapshot);
    /// Reads from the live session what the far end allows. To be called once the link works in the mode that was set.
    void learnConsent(const engine::Snapshot &snapshot);
    /// A run in plain MAVLink succeeded: later silence in plain is caused by the link, not by missing consent. The same with a
    /// bare cipher and its key.
    void plainSucceeded()
    {
        m_plainSucceeded = true;
        m_bareSucceeded = m_bareSucceeded || m_bareCipher;
    }
    /// No vehicle was heard in plain MAVLink.
    void plainSilent() { m_plainRefused = !m_plainSucceeded; }
    /// Nothing of the vehicle was decrypted under a bare cipher.
    void bareSilent() { m_bareRefused = !m_bareSucceeded; }

    /// Also with a bare cipher.
    bool isPlain() const { return m_protection == engine::Protection::Plain; }
    bool isCarriedAs(engine::Protection protection) const { return m_protection == protection && !m_bareCipher; }
    /// As a run of this arm requires.
    bool isCarriedAs(const SweepArm &arm) const;
    std::optional<crypto::MavsecKind> bareCipher() const { return m_bareCipher; }
    /// Suite of the first session that was seen; nullopt before.
    std::optional<crypto::SuiteId> firstSuite() const { return m_firstSuite; }
    /// Why the far end cannot be measured like this; empty if nothing is known against it.
    Reason refusal(const SweepArm &arm) const;

    /// The live session; null without one. Points into the snapshot.
    const engine::SessionSnapshot *session(const engine::Snapshot &snapshot) const;
    /// True in plain MAVLink, or if the live session uses this suite and no switch to another one is pending.
    bool isUnder(crypto::SuiteId suite, const engine::Snapshot &snapshot) const;
    /// True if a vehicle is heard under the protection that is set.
    bool hasVehicle(const engine::Snapshot &snapshot) const;
    /// The same, and where its payloads are encrypted, that it answered: a wrong key has no answers.
    bool hasReadableVehicle(const engine::Snapshot &snapshot) const;
    /// The same as hasVehicle() for a vehicle that knows its position. Before that, it sends more and the station requests more
    /// than later.
    bool hasSettledVehicle(const engine::Snapshot &snapshot) const;
    /// True if a vehicle has answered TIMESYNC since setProtection() or setBareCipher(), so that both directions work.
    bool isAnswering(const engine::Snapshot &snapshot) const;
    /// True if the live session uses the suite that the link had first, and nothing is pending.
    bool isRestored(const engine::Snapshot &snapshot) const;

private:
    bool isHeard(const engine::Snapshot &snapshot, const engine::VehicleSnapshot &vehicle) const;

    std::optional<engine::Protection> m_protection;
    std::optional<crypto::MavsecKind> m_bareCipher;
    std::optional<channel::SessionId> m_ending; ///< the session that the last change of protection ends
    double m_answersBefore = 0;                 ///< TIMESYNC answers before that change
    channel::Framing m_framing{};               ///< of the newest session
    bool m_plainRefused = false, m_inlineRefused = false, m_bareRefused = false;
    bool m_plainSucceeded = false, m_bareSucceeded = false;
    std::optional<crypto::SuiteId> m_firstSuite;
};

} // namespace skyseal::experiment
