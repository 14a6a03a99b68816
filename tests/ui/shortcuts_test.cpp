// The shortcuts of the actions in the menus: changed, taken from another action, refused and reset by real keys; kept in the
// settings; and a changed key commands no sooner than the one before.
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/shortcuts/shortcut_model.h"
#include "ui/shortcuts/shortcut_rules.h"
#include "ui/shortcuts/shortcuts.h"
#include "window_rig.h"

#include <QtCore/QSet>
#include <QtGui/QAction>
#include <QtGui/QStandardItemModel>
#include <QtTest/QAbstractItemModelTester>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QDockWidget>
#include <QtWidgets/QKeySequenceEdit>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QTreeView>

using namespace skyseal;
using namespace skyseal::ui;

class ShortcutsTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init() { setUpWithDemo(); }
    void cleanup() { tearDown(); }

    void keysThatOthersNeedAreRefused_data()
    {
        QTest::addColumn<QKeySequence>("keys");
        QTest::addColumn<QString>("reason"); // empty: they are permitted
        const auto row = [](const char *text, const QString &reason) {
            QTest::newRow(text) << QKeySequence(QLatin1String(text)) << reason;
        };
        const QString map = QStringLiteral("the map"), arrows = QStringLiteral("arrows"),
                      press = QStringLiteral("press buttons"), edits = QStringLiteral("edits texts");
        for (const char *text : {"A", "Shift+A", "5", "+", "Home", "PgUp", "Ins"})
            row(text, map);
        for (const char *text : {"Left", "Ctrl+Up", "Ctrl+Alt+Down"})
            row(text, arrows);
        for (const char *text : {"Space", "Return", "Enter", "Ctrl+Return", "Ctrl+Space"})
            row(text, press);
        for (const char *text : {"Ctrl+C", "Ctrl+V", "Ctrl+A", "Ctrl+Z", "Del"})
            row(text, edits);
        row("Tab", QStringLiteral("Tab moves"));
        row("Ctrl+Tab", QStringLiteral("Tab moves"));
        row("Esc", QStringLiteral("Esc closes"));
        row("Alt+F", QStringLiteral("Alt with a letter"));
        row("Shift+F10", QStringLiteral("opens the menu"));
        row("Ctrl+K, Ctrl+L", QStringLiteral("at once"));
        for (const char *text : {"", "F5", "Shift+F5", "Ctrl+L", "Ctrl+Shift+L", "Alt+5", "Alt+Shift+L", "Ctrl+Home", "Meta+L"})
            row(text, {});
    }
    void keysThatOthersNeedAreRefused()
    {
        QFETCH(QKeySequence, keys);
        QFETCH(QString, reason);
        const QString refusal = shortcutRefusal(keys);
        QCOMPARE(refusal.isEmpty(), reason.isEmpty());
        QVERIFY2(refusal.contains(reason), qPrintable(refusal));
    }

    void everyActionHasKeysOfItsOwn()
    {
        QSet<QKeySequence> used;
        QStringList without, shared;
        for (const Shortcuts::Item &item : shortcuts().items()) {
            QVERIFY2(shortcutRefusal(item.first).isEmpty(), qPrintable(shortcutRefusal(item.first)));
            if (item.first.isEmpty())
                without << item.action->objectName();
            else if (used.contains(item.first))
                shared << item.action->objectName() + QLatin1Char(' ') + item.first.toString();
            else
                QCOMPARE(item.action->shortcut(), item.first);
            used.insert(item.first);
        }
        QCOMPARE(without, QStringList());
        QCOMPARE(shared, QStringList());
        QVERIFY(used.size() > 80);
    }

    /// Those of the panels as well: see panel_actions_test.
    void everyActionOfTheMenusIsListed()
    {
        QSet<QString> ids;
        for (const Shortcuts::Item &item : shortcuts().items())
            ids.insert(item.action->objectName());
        QCOMPARE(ids.size(), static_cast<qsizetype>(shortcuts().items().size()));
        for (const QAction *top : m_window->menuBar()->actions())
            for (const QAction *action : top->menu()->actions())
                QVERIFY2(action->isSeparator() || action->menu() || ids.contains(action->objectName()),
                         qPrintable(action->text()));
    }

    void everyPanelHasAKey()
    {
        for (const QAction *action : m_window->findChildren<QAction *>())
            if (action->objectName().startsWith(QLatin1String("view_dock")))
                QVERIFY2(!action->shortcut().isEmpty(), qPrintable(action->objectName()));
        auto *dock = find<QDockWidget>("dockVehicles");
        dock->hide();
        press(Qt::Key_Minus, Qt::AltModifier);
        QVERIFY(dock->isVisible());
    }

    void modelIsAModel()
    {
        ShortcutModel model(shortcuts());
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        const int zoom = itemOf("actionZoomIn"), row = itemOf("actionQuit");
        shortcuts().choose(row, shortcuts().keys(zoom));
        const auto text = [&](int at, ShortcutModel::Column column) { return model.index(at, column).data().toString(); };
        QCOMPARE(text(row, ShortcutModel::Action), QStringLiteral("Quit"));
        QCOMPARE(text(row, ShortcutModel::Menu), QStringLiteral("File"));
        QCOMPARE(text(row, ShortcutModel::Keys), QStringLiteral("Ctrl++"));
        QCOMPARE(text(row, ShortcutModel::First), QStringLiteral("Ctrl+Q"));
        QCOMPARE(text(zoom, ShortcutModel::Keys), QString());
        QCOMPARE(model.index(zoom, ShortcutModel::Keys).data(Qt::AccessibleTextRole).toString(), QStringLiteral("none"));
        shortcuts().resetAll();
        QCOMPARE(text(row, ShortcutModel::Keys), QStringLiteral("Ctrl+Q"));
        QCOMPARE(text(zoom, ShortcutModel::Keys), QStringLiteral("Ctrl++"));
    }

    void aChangedKeyStays()
    {
        select(QStringLiteral("map source"));
        QTest::keyClick(find<QLineEdit>("shortcutFind"), Qt::Key_Return); // to the field
        EVENTUALLY(keys()->hasFocus());
        QTest::keyClick(keys(), Qt::Key_J, Qt::ControlModifier);
        QCOMPARE(note(), QStringLiteral("Ctrl+J is now that of \"Map source…\"."));
        QCOMPARE(find<QAction>("actionMapSource")->shortcut(),
                 QKeySequence(Qt::CTRL | Qt::Key_J)); // of the menu and the palette
        QTest::keyClick(keys(), Qt::Key_Escape);
        EVENTUALLY(!dialog("shortcutDialog"));
        for (const bool again : {false, true}) {
            if (again)
                open(); // with the same settings
            press(Qt::Key_M, Qt::ControlModifier);
            QVERIFY(!dialog("mapSourceDialog"));
            press(Qt::Key_J, Qt::ControlModifier);
            QVERIFY(dialog("mapSourceDialog"));
            QVERIFY(paletteNotes().contains(QStringLiteral("Ctrl+J")));
        }
    }

    void keysOfAnotherActionAreTakenByReplaceOnly()
    {
        select(QStringLiteral("quit"));
        QTest::keyClick(keys(), Qt::Key_F12);
        QCOMPARE(note(), QStringLiteral("F12 is that of \"Connect…\"; it would lose it."));
        QCOMPARE(keysOf("actionQuit"), QStringLiteral("Ctrl+Q"));
        QCOMPARE(keysOf("actionConnect"), QStringLiteral("F12"));
        QTest::mouseClick(find<QPushButton>("shortcutReplace"), Qt::LeftButton);
        QCOMPARE(keysOf("actionQuit"), QStringLiteral("F12"));
        QCOMPARE(keysOf("actionConnect"), QString());
        QVERIFY(!find<QPushButton>("shortcutReplace")->isEnabled());
        open();
        QCOMPARE(keysOf("actionQuit"), QStringLiteral("F12"));
        QCOMPARE(keysOf("actionConnect"), QString());
        // The default of one that lost its keys is asked for in the same way.
        select(QStringLiteral("link connect"));
        QTest::mouseClick(find<QPushButton>("shortcutReset"), Qt::LeftButton);
        QCOMPARE(note(), QStringLiteral("F12 is that of \"Quit\"; it would lose it."));
        QCOMPARE(keysOf("actionConnect"), QString());
    }

    void anotherRowForgetsWhatWasAsked()
    {
        select(QStringLiteral("zoom"));
        QTest::keyClick(keys(), Qt::Key_F12);
        QVERIFY(find<QPushButton>("shortcutReplace")->isEnabled());
        QTest::keyClick(find<QTreeView>("shortcutView"), Qt::Key_Down);
        QVERIFY(!find<QPushButton>("shortcutReplace")->isEnabled());
        QVERIFY(note().isEmpty());
        QCOMPARE(keysOf("actionConnect"), QStringLiteral("F12"));
    }

    void refusedKeysChangeNothing()
    {
        select(QStringLiteral("quit"));
        for (const Qt::Key key : {Qt::Key_M, Qt::Key_Left, Qt::Key_Space, Qt::Key_Return}) {
            QTest::keyClick(keys(), key);
            QVERIFY2(note().contains(QStringLiteral("cannot be a shortcut")), qPrintable(note()));
            QCOMPARE(keys()->keySequence(), QKeySequence(Qt::CTRL | Qt::Key_Q));
        }
        keys()->setFocus();
        EVENTUALLY(keys()->hasFocus());
        QTest::keyClick(keys(), Qt::Key_Tab); // a way out by keys
        QVERIFY(!keys()->hasFocus());
        QCOMPARE(keysOf("actionQuit"), QStringLiteral("Ctrl+Q"));
        QVERIFY(m_store->childGroups().isEmpty() || !m_store->childGroups().contains(QStringLiteral("shortcuts")));
    }

    void oneAndAllAreReset()
    {
        select(QStringLiteral("quit"));
        QTest::keyClick(keys(), Qt::Key_Backspace);
        QCOMPARE(note(), QStringLiteral("\"Quit\" has no shortcut now."));
        QCOMPARE(keysOf("actionQuit"), QString());
        open();
        QCOMPARE(keysOf("actionQuit"), QString()); // none is a choice as well
        select(QStringLiteral("quit"));
        QTest::mouseClick(find<QPushButton>("shortcutReset"), Qt::LeftButton);
        QCOMPARE(keysOf("actionQuit"), QStringLiteral("Ctrl+Q"));
        QTest::keyClick(keys(), Qt::Key_F9);
        select(QStringLiteral("full screen"));
        QTest::keyClick(keys(), Qt::Key_F8, Qt::ControlModifier);
        QTest::mouseClick(find<QPushButton>("shortcutResetAll"), Qt::LeftButton);
        auto *question = find<QMessageBox>("confirmResetShortcuts");
        QCOMPARE(keysOf("actionQuit"), QStringLiteral("F9"));
        QTest::mouseClick(question->button(QMessageBox::Yes), Qt::LeftButton);
        QCOMPARE(keysOf("actionQuit"), QStringLiteral("Ctrl+Q"));
        QCOMPARE(keysOf("actionFullScreen"), QStringLiteral("F11"));
        open();
        QCOMPARE(keysOf("actionQuit"), QStringLiteral("Ctrl+Q"));
    }

    void whatIsStoredWrongIsIgnored()
    {
        const auto store = [this](const char *id, const char *keys) {
            m_store->setValue(QStringLiteral("shortcuts/") + QLatin1String(id), QLatin1String(keys));
        };
        store("actionOfAnotherVersion", "F5");
        store("actionQuit", "no keys at all");
        store("actionReplay", "Space");
        store("actionConnect", "F7");
        store("actionKeys", "F7");
        store("actionMapSource", "F11"); // the default of another one
        open();
        QCOMPARE(keysOf("actionQuit"), QStringLiteral("Ctrl+Q"));
        QCOMPARE(keysOf("actionReplay"), QStringLiteral("Ctrl+O"));
        QCOMPARE(keysOf("actionConnect"), QStringLiteral("F7"));
        QCOMPARE(keysOf("actionKeys"), QString()); // of two with the same keys Qt would obey none
        QCOMPARE(keysOf("actionMapSource"), QStringLiteral("F11"));
        QCOMPARE(keysOf("actionFullScreen"), QString());
        QVERIFY(m_store->contains(QStringLiteral("shortcuts/actionOfAnotherVersion")));
    }

    void tipsShowTheChangedKeys()
    {
        shortcuts().choose(itemOf("workspace_plan"), QKeySequence(Qt::Key_F6));
        QToolButton *plan = nullptr;
        for (auto *button : find<QWidget>("workspaceTabs")->findChildren<QToolButton *>())
            if (button->defaultAction()->objectName() == QLatin1String("workspace_plan"))
                plan = button;
        QVERIFY(plan);
        QCOMPARE(plan->toolTip(), QStringLiteral("Workspace Plan (F6)"));
    }

    /// No menu was opened since the vehicle appeared, or disappeared.
    void shortcutsKnowWhatIsPossibleNow()
    {
        press(Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(questions().isEmpty());
        Q_EMIT find<QMenu>("menuVehicle")->aboutToShow(); // disables it
        m_station->showSealed(1);
        press(Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(questions().size(), qsizetype(1));
    }

    /// A key that is held asks once; and held over, it does not answer.
    void aChangedKeyCommandsNoSooner()
    {
        m_station->showSealed(1);
        shortcuts().choose(itemOf("actionLand"), QKeySequence(Qt::Key_F7));
        press(Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(questions().isEmpty());
        activate(*m_window);
        for (const bool repeat : {false, true, true, true})
            QTest::simulateEvent(m_window.get(), true, Qt::Key_F7, Qt::NoModifier, QString(), repeat);
        QTest::keyPress(m_window.get(), Qt::Key_F7); // as X11 repeats it, before the question is the active window
        QCOMPARE(questions().size(), qsizetype(1));
        auto *yes = questions().front()->button(QMessageBox::Yes);
        QCOMPARE(yes->text(), QStringLiteral("Land"));
        yes->setFocus();
        for (const Qt::Key key : {Qt::Key_F7, Qt::Key_Space, Qt::Key_Return})
            QTest::simulateEvent(yes, true, key, Qt::NoModifier, QString(), true);
        QVERIFY(m_station->commands.empty());
        for (const Qt::Key key : {Qt::Key_F7, Qt::Key_Space, Qt::Key_Return})
            QTest::keyRelease(yes, key);
        QTest::mouseClick(yes, Qt::LeftButton);
        QCOMPARE(m_station->commands.size(), std::size_t(1));
        QVERIFY(std::holds_alternative<vehicle::Land>(m_station->commands[0].second));
    }

    void theNewestQuestionStays()
    {
        m_station->showSealed(1);
        find<QAction>("actionStartMission")->trigger();
        find<QAction>("actionLand")->trigger();
        QCOMPARE(questions().size(), qsizetype(1));
        QVERIFY(questions().front()->text().contains(QStringLiteral("Land")));
        QVERIFY(m_station->commands.empty());
    }

private:
    Shortcuts &shortcuts() const { return *m_window->findChild<Shortcuts *>(); }
    int itemOf(const char *id) const
    {
        const auto &items = shortcuts().items();
        for (std::size_t i = 0; i < items.size(); ++i)
            if (items[i].action->objectName() == QLatin1String(id))
                return static_cast<int>(i);
        qFatal("no action %s", id);
    }
    QString keysOf(const char *id) const { return find<QAction>(id)->shortcut().toString(QKeySequence::PortableText); }
    static void activate(QWidget &window)
    {
        window.activateWindow();
        EVENTUALLY(QApplication::activeWindow() == &window);
    }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers)
    {
        activate(*m_window);
        QTest::keyClick(m_window.get(), key, modifiers);
    }
    /// Null while none is open.
    QDialog *dialog(const char *name) const
    {
        for (auto *found : m_window->findChildren<QDialog *>(QLatin1String(name)))
            if (found->isVisible())
                return found;
        return nullptr;
    }
    /// Opens the dialog and types what selects an action.
    void select(const QString &words)
    {
        if (!dialog("shortcutDialog"))
            press(Qt::Key_F1, Qt::ControlModifier | Qt::ShiftModifier);
        EVENTUALLY(dialog("shortcutDialog"));
        activate(*dialog("shortcutDialog"));
        auto *typed = find<QLineEdit>("shortcutFind");
        typed->clear();
        QTest::keyClicks(typed, words);
    }
    QKeySequenceEdit *keys() const { return find<QKeySequenceEdit>("shortcutKeys"); }
    QString note() const { return find<QLabel>("shortcutNote")->text(); }
    QList<QMessageBox *> questions() const
    {
        QList<QMessageBox *> open;
        for (auto *box : m_window->findChildren<QMessageBox *>(QStringLiteral("confirmCommand")))
            if (box->isVisible())
                open << box;
        return open;
    }
    /// The right column of the palette.
    QStringList paletteNotes()
    {
        find<QAction>("actionPalette")->trigger();
        const auto *model = qobject_cast<QStandardItemModel *>(find<QTreeView>("paletteList")->model());
        QStringList notes;
        for (int row = 0; row < model->rowCount(); ++row)
            notes << model->item(row, 1)->text();
        dialog("commandPalette")->close();
        return notes;
    }
};

SKYSEAL_TEST_WIDGETS(ShortcutsTest)
#include "shortcuts_test.moc"
