// Connects the engine, the window and the demo.
#pragma once

#include "core/base/random_source.h"
#include "app/skyseal/demo.h"
#include "app/common/peers_watch.h"
#include "app/skyseal/demo_flight.h"
#include "app/skyseal/keyring.h"
#include "app/skyseal/own_files.h"
#include "app/skyseal/passphrase_question.h"
#include "app/skyseal/run_marker.h"
#include "app/skyseal/station_adapter.h"
#include "app/skyseal/sweep_controller.h"
#include "app/skyseal/window_pairing.h"
#include "ui/window/main_window.h"
#include "app/skyseal/window_options.h"

#include <QtCore/QSettings>

namespace skyseal::app {

class Application : public QObject
{
    Q_OBJECT

public:
    /// `random` must outlive it. `heap` is created before threads start; without it the memory of suites is not shown.
    /// `memory` stores passphrases; null: the desktop's keyring.
    Application(WindowOptions options, RandomSource &random, std::shared_ptr<experiment::HeapFigures> heap = {},
                std::unique_ptr<PassphraseMemory> memory = {});
    ~Application() override;

    /// Shows the window. Returns false, with a message on stderr, if no station can be created.
    bool start();
    /// Ends the program in an orderly way, without a question.
    void stop();

private:
    engine::StationConfig configOf(const ui::Settings &settings, engine::KeyPaths keys) const;
    engine::KeyPaths chooseKeys();
    void useKeys(const engine::KeyPaths &keys);
    void showKeyState();
    void reportKeyProblem();
    void openKeyAndLinks(bool locked);
    void askForPassphrase(ui::RefusedPassphrase refused = ui::RefusedPassphrase::None);
    void useOpenedKeys(const PassphraseQuestion::Identity &identity);
    void takeKeyProblem(const InputError &why);
    void exchangeStation(const engine::KeyPaths &keys);
    void reportLeftOutPeers(const keys::PeersInForce &peers);
    void makeWindow();
    QStringList linksOfStart() const;
    void keepLinks();
    void openKeptLinks();
    void markRun(const engine::Snapshot &snapshot);
    void offerRescue();
    void startDemo();
    void endDemo();
    void beginDemo();
    void followLink(const link::LinkUrl &url);
    void takeScreenshot();
    void collectHeapFigures();

    WindowOptions m_options;
    RandomSource &m_random;
    const std::shared_ptr<experiment::HeapFigures> m_heap;
    QSettings m_store;
    QString m_keyProblem;
    const std::unique_ptr<PassphraseMemory> m_memory;
    PassphraseQuestion m_question{*m_memory};
    Keyring m_keyring{m_store, *m_memory};
    WindowPairing m_pairing;
    engine::KeyPaths m_keys;
    RunMarker m_marker{dataFolder() + QStringLiteral("/runs")};
    std::unique_ptr<StationAdapter> m_station;
    std::unique_ptr<SweepController> m_sweep;
    std::unique_ptr<PeersWatch> m_peersWatch;
    std::unique_ptr<ui::MainWindow> m_window;
    std::unique_ptr<Demo> m_demo;
    std::unique_ptr<DemoFlight> m_demoFlight;
    QStringList m_keptLinks; ///< of the user, while the demo runs or the key is being opened
};

} // namespace skyseal::app
