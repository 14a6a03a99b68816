#include "ui/sweep/sweep_permits.h"

#include "core/base/research.h"
#include "core/engine/station/snapshot.h"
#include "ui/security/suite_actions.h"

#include <QtCore/QCoreApplication>

#include <algorithm>

namespace skyseal::ui {

using crypto::SuiteId;

namespace {

struct SweepPermitsText
{
    Q_DECLARE_TR_FUNCTIONS(Sweep)
};

} // namespace

bool hasArmedVehicle(const ViewState &view)
{
    return view.snapshot
        && std::ranges::any_of(view.snapshot->vehicles, [](const auto &vehicle) { return vehicle.state.armed; });
}

QString connectedLinkDisabledReason(const SweepContext &context)
{
    const ViewState &view = context.view;
    if (!view.snapshot || (!view.vehicle && !view.session))
        return SweepPermitsText::tr("nothing is connected");
    if (!view.session)
        return SweepPermitsText::tr("the link is not sealed");
    if (view.session->info.silent)
        return SweepPermitsText::tr("the link is silent");
    const auto clear = [](const engine::VehicleSnapshot &vehicle) { return !vehicle.session && !vehicle.state.lost; };
    if (view.snapshot->sessions.size() > 1 || std::ranges::any_of(view.snapshot->vehicles, clear))
        return SweepPermitsText::tr("other links would be measured as well: keep only one sealed link open");
    return {};
}

QString suiteDisabledReason(const SweepContext &context, SweepTarget target, SuiteId suite)
{
    if (suite == SuiteId::None && !kResearch)
        return SweepPermitsText::tr("not in this build");
    if (!crypto::suiteAvailable(suite) && suite != SuiteId::None)
        return SweepPermitsText::tr("missing on this machine");
    if (hasOwnAgent(target))
        return {};
    if (suite != SuiteId::None)
        return context.suites.disabledReason(suite);
    if (context.requireSealed)
        return SweepPermitsText::tr("the settings require sealing");
    if (!context.view.session)
        return SweepPermitsText::tr("no sealed link yet");
    const auto &offered = context.view.session->info.peerOffered;
    if (std::ranges::find(offered, SuiteId::None) == offered.end())
        return SweepPermitsText::tr("the agent does not allow it (skyseal-air --allow-plain)");
    if (hasArmedVehicle(context.view))
        return SweepPermitsText::tr("not while the vehicle is armed");
    return {};
}

QString inlineDisabledReason(const SweepContext &context, SweepTarget target)
{
    if (!kResearch)
        return SweepPermitsText::tr("not in this build");
    // It needs a new session, during which no commands can be sent.
    if (!hasOwnAgent(target) && hasArmedVehicle(context.view))
        return SweepPermitsText::tr("not while the vehicle is armed");
    return {};
}

QString otherLinkDisabledReason(SweepTarget target)
{
    return hasOwnAgent(target) ? QString() : SweepPermitsText::tr("the connected link is measured as it is");
}

QString saturatedDisabledReason(SweepTarget target)
{
    switch (target) {
    case SweepTarget::Connected: return SweepPermitsText::tr("the load of a connected vehicle cannot be changed");
    case SweepTarget::Autopilot: return SweepPermitsText::tr("the autopilot sets its own rates");
    case SweepTarget::Simulated: break;
    }
    return {};
}

} // namespace skyseal::ui
