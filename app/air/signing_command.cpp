#include "app/air/signing_command.h"

#include "app/common/exit_status.h"
#include "app/common/output.h"
#include "app/common/process.h"
#include "core/base/json_writer.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/system_random.h"
#include "core/engine/agent/signing_task.h"
#include "core/engine/common/deadline_timer.h"
#include "core/keys/file_io.h"
#include "core/link/address_text.h"
#include "core/link/make_link.h"
#include "core/mavlink/frame_intake.h"

#include <QtCore/QCoreApplication>

namespace skyseal::app {

namespace {

using engine::SigningAction;
using engine::SigningOutcome;

const QString kName = QStringLiteral("skyseal-air");

struct SigningPlan
{
    SigningAction action{};
    std::optional<link::LinkUrl> vehicle;
    std::string keyFile;
    bool json = false;
};

std::optional<SigningAction> actionNamed(const std::string &name)
{
    if (name == "setup")
        return SigningAction::SetUp;
    if (name == "check")
        return SigningAction::Check;
    if (name == "remove")
        return SigningAction::Remove;
    return std::nullopt;
}

/// Whether the bytes of the link leave this machine over a network. The other end of a serial port cannot be known.
bool mayBeOverheard(const link::LinkUrl &url)
{
    switch (url.type().target) {
    case link::LinkTarget::DeviceBaud:
    case link::LinkTarget::File: return false;
    case link::LinkTarget::HostPort: break;
    }
    if (url.host() == "localhost")
        return false;
    const auto address = link::parseHost(url.host(), url.port());
    return !address || !link::toQt(*address).isLoopback();
}

std::string sentenceOf(SigningAction action, const SigningOutcome &outcome)
{
    using Finding = SigningOutcome::Finding;
    const std::string vehicle = "vehicle " + std::to_string(outcome.systemId);
    switch (outcome.finding) {
    case Finding::Works:
        return vehicle + " signs with this key and accepts messages that are signed with it"
            + (outcome.acceptsUnsigned ? "; it obeys unsigned messages on this link as well, as autopilots do on a USB port"
                                       : "");
    case Finding::Refuses:
        return action == SigningAction::Remove
            ? vehicle + " still signs: it did not accept the change"
            : vehicle + " signs with this key, but does not answer messages that are signed with it";
    case Finding::NotSigned:
        if (action == SigningAction::Remove)
            return vehicle + " does not sign";
        return action == SigningAction::SetUp ? vehicle + " did not accept the key: does its firmware support MAVLink signing?"
                                              : vehicle + " does not sign; skyseal-air --signing setup sets it up";
    case Finding::OtherKey:
        return vehicle + " signs with another key; remove that key first, with --signing remove and its file";
    case Finding::Armed: return vehicle + " is armed: nothing was changed";
    case Finding::SeveralVehicles:
        return "several vehicles are heard on this link: nothing was sent; connect one of them alone";
    case Finding::NoVehicle: break;
    }
    return "no autopilot was heard on this link within 10 seconds";
}

std::string_view keywordOf(SigningOutcome::Finding finding)
{
    using Finding = SigningOutcome::Finding;
    switch (finding) {
    case Finding::Works: return "works";
    case Finding::Refuses: return "refused";
    case Finding::NotSigned: return "not_signed";
    case Finding::OtherKey: return "other_key";
    case Finding::Armed: return "armed";
    case Finding::SeveralVehicles: return "several_vehicles";
    case Finding::NoVehicle: break;
    }
    return "no_vehicle";
}

int report(const SigningPlan &plan, const SigningOutcome &outcome)
{
    if (plan.json) {
        JsonWriter json;
        json.beginObject().field("event", "signing").field("result", keywordOf(outcome.finding));
        json.field("done", outcome.reached).field("sysid", std::uint32_t(outcome.systemId));
        json.field("accepts_unsigned", outcome.acceptsUnsigned).endObject();
        printLine(json.text());
    } else {
        printLine(sentenceOf(plan.action, outcome));
    }
    return outcome.reached ? kDone : kNotReached;
}

/// Connects a task with the link, the clock and the event loop.
class SigningRun : private link::LinkListener
{
public:
    SigningRun(SigningPlan plan, std::unique_ptr<engine::SigningTask> task)
        : m_plan(std::move(plan)), m_task(std::move(task)), m_link(link::makeLink(*m_plan.vehicle, LinkId{1}, *this)),
          m_timer([this] {
              m_task->handleDeadline(steadyNow());
              turn();
          })
    {
        QObject::connect(m_link.get(), &link::Link::stateChanged, m_link.get(), [this](link::LinkState state) {
            if (state == link::LinkState::Failed || state == link::LinkState::Waiting) {
                complain(kName,
                         m_link->url().toText() + ": " + m_link->error().sentence() + "; is it in use by a running agent?");
                QCoreApplication::exit(kCannotOpen);
            }
        });
    }

    void start()
    {
        m_link->open();
        turn();
    }

private:
    void linkReceived(link::Link &link, std::span<const link::ReceivedBlock> blocks) override
    {
        for (const link::ReceivedBlock &block : blocks) {
            const auto take = [&](const mavlink::ScanItem &item) {
                if (item.frame)
                    m_task->handleFrame(block.time, block.path, *item.frame);
            };
            if (link.isStream())
                m_intake.takeStream(block.path, block.bytes, take);
            else
                m_intake.takeDatagram(block.time, block.path, block.bytes, take);
        }
        turn();
    }
    void linkPeerLeft(link::Link &, const Path &path) override { m_intake.forget(path); }

    void turn()
    {
        while (const auto out = m_task->pollTransmit())
            m_link->send(out->to.remote, out->bytes);
        m_link->flush();
        m_timer.set(m_task->nextDeadline());
        if (m_task->outcome() && !m_reported) {
            m_reported = true;
            QCoreApplication::exit(report(m_plan, *m_task->outcome()));
        }
    }

    const SigningPlan m_plan;
    std::unique_ptr<engine::SigningTask> m_task;
    std::unique_ptr<link::Link> m_link;
    mavlink::FrameIntake m_intake{mavlink::Dialect::builtin()};
    engine::DeadlineTimer m_timer;
    bool m_reported = false;
};

/// Returns false if it cannot be made.
bool makeMissingKey(const std::string &file)
{
    if (keys::fileExists(file))
        return true;
    crypto::SystemRandom random;
    if (const auto written = engine::writeNewVehicleKey(file, random); !written) {
        complain(kName, written.error().text());
        return false;
    }
    remark(file + ": created, a new signing key");
    return true;
}

} // namespace

void declareSigning(Options &options)
{
    options.addValue(
        "vehicle-signing", "FILE",
        "Key of MAVLink signing that the autopilot shares with this agent (32 bytes, or 64 hex digits): messages "
        "to the vehicle are signed, and only messages that the vehicle signed are forwarded to the ground. See --signing.");
    options.addFlag(
        "accept-unsigned",
        "With --vehicle-signing: also forward unsigned messages of the vehicle side to the ground, such as those of "
        "gimbals and cameras that cannot sign.");
    options.addValue(
        "signing", "setup|check|remove",
        "Do not start an agent, but send the key of --vehicle-signing to the vehicle (created if the file is missing), check "
        "whether the vehicle signs with it and accepts messages that are signed with it, or disable its signing. Stop the "
        "agent first, since it uses the link of --vehicle.");
    options.addFlag(
        "send-key-in-clear",
        "With --signing setup: send the key even over a network, where others may read it. USB, a serial line or loopback "
        "is safer.");
}

int runSigning(Options &options)
{
    SigningPlan plan;
    const auto action = actionNamed(options.text("signing"));
    if (!action)
        options.fail("--signing '" + options.text("signing") + "': setup, check or remove is expected");
    else
        plan.action = *action;
    options.required("vehicle");
    plan.vehicle = options.url("vehicle", link::LinkUrl::kLoopback);
    plan.keyFile = options.required("vehicle-signing");
    plan.json = options.has("json");
    const bool sendsKey = plan.action == SigningAction::SetUp && plan.vehicle && mayBeOverheard(*plan.vehicle);
    if (sendsKey && !options.has("send-key-in-clear"))
        options.fail("--signing setup would send the key in clear over " + plan.vehicle->toText()
                     + ", where others may read it: use USB, a serial line or loopback, or add --send-key-in-clear");
    if (const auto status = options.finish())
        return *status;
    if (sendsKey)
        remark("warning: the signing key is sent in clear over " + plan.vehicle->toText());
    if (!crypto::initCrypto()) {
        complain(kName, "the system provides no randomness");
        return kCannotOpen;
    }
    if (plan.action == SigningAction::SetUp && !makeMissingKey(plan.keyFile))
        return kCannotOpen;
    auto key = engine::readVehicleKey(plan.keyFile);
    if (!key) {
        complain(kName, key.error().text());
        return kCannotOpen;
    }
    SigningRun run(std::move(plan), std::make_unique<engine::SigningTask>(*action, std::move(*key), steadyNow()));
    StopSignals signals;
    QObject::connect(&signals, &StopSignals::stopRequested, &signals, [] { QCoreApplication::exit(kNotReached); });
    QTimer::singleShot(0, &signals, [&run] { run.start(); });
    return QCoreApplication::exec();
}

} // namespace skyseal::app
