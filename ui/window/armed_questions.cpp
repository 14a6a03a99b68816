#include "ui/window/armed_questions.h"

#include "core/engine/station/snapshot.h"
#include "core/engine/text/qt_text.h"
#include "ui/confirm_box.h"
#include "ui/view_state.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QStringList>

#include <utility>

namespace skyseal::ui {

namespace {

struct ArmedQuestionsText
{
    Q_DECLARE_TR_FUNCTIONS(ArmedQuestions)
};

void ask(Question question, QWidget *window, std::function<void()> confirmed)
{
    question.icon = QMessageBox::Warning;
    askToConfirm(question, window, window, std::move(confirmed));
}

template<typename Accepts> QString armedAmong(const engine::Snapshot &snapshot, Accepts accepts)
{
    QStringList armed;
    for (const engine::VehicleSnapshot &vehicle : snapshot.vehicles)
        if (vehicle.state.armed && accepts(vehicle))
            armed << QString::number(vehicle.state.systemId);
    return armed.join(QStringLiteral(", "));
}

bool areSeveral(const QString &armed)
{
    return armed.contains(QLatin1Char(','));
}

} // namespace

QString armedVehicles(const engine::Snapshot &snapshot)
{
    return armedAmong(snapshot, [](const engine::VehicleSnapshot &) { return true; });
}

QString armedVehiclesOf(const engine::Snapshot &snapshot, const QString &peer)
{
    return armedAmong(snapshot, [&](const engine::VehicleSnapshot &vehicle) {
        const engine::SessionSnapshot *session = sessionOf(snapshot, vehicle);
        return session && engine::fromStd(session->info.peerName) == peer;
    });
}

void askToReplay(const QString &armed, QWidget *window, std::function<void()> replay)
{
    ask({.objectName = QStringLiteral("confirmReplay"),
         .title = ArmedQuestionsText::tr("Replay a log"),
         .text = areSeveral(armed) ? ArmedQuestionsText::tr("Vehicles %1 are armed. Replay a log?").arg(armed)
                                   : ArmedQuestionsText::tr("Vehicle %1 is armed. Replay a log?").arg(armed),
         .details = ArmedQuestionsText::tr("No vehicle can be commanded until you go back to the live picture."),
         .yes = ArmedQuestionsText::tr("Replay")},
        window, std::move(replay));
}

void askToQuit(const QString &armed, QWidget *window, std::function<void()> quit)
{
    ask({.objectName = QStringLiteral("confirmQuit"),
         .title = ArmedQuestionsText::tr("Quit Skyseal"),
         .text = areSeveral(armed) ? ArmedQuestionsText::tr("Vehicles %1 are armed. Quit?").arg(armed)
                                   : ArmedQuestionsText::tr("Vehicle %1 is armed. Quit?").arg(armed),
         .details = ArmedQuestionsText::tr(
             "While Skyseal is closed, no vehicle can be commanded from here, and failsafes may trigger."),
         .yes = ArmedQuestionsText::tr("Quit")},
        window, std::move(quit));
}

} // namespace skyseal::ui
