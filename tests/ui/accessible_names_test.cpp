// Everything that the keyboard reaches has a name that a screen reader can say: all widgets of the window in its states, of all
// dialogs and all entries of menus; and no two controls of one dialog or panel have the same.
#include "fake_keyring.h"
#include "fake_pairing.h"
#include "gallery_dialogs.h"
#include "tests/support/test_runner.h"
#include "ui/map/map_view.h"
#include "window_rig.h"
#include "window_states.h"

#include <QtCore/QDirIterator>
#include <QtCore/QFile>
#include <QtCore/QHash>
#include <QtCore/QRegularExpression>
#include <QtCore/QSet>
#include <QtGui/QAccessible>
#include <QtGui/QAction>
#include <QtGui/QContextMenuEvent>
#include <QtTest/QTest>
#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QApplication>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialog>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLabel>
#include <QtWidgets/QMenu>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QSpinBox>
#include <QtWidgets/QTabBar>
#include <QtWidgets/QToolBar>

using namespace skyseal;
using namespace skyseal::ui;

namespace {

/// Pieces that Qt makes inside a control, which has the name, or whose own children have names.
bool isPieceOfQt(const QWidget &widget)
{
    const auto *parent = widget.parentWidget();
    const QByteArray name = widget.metaObject()->className();
    return widget.objectName().startsWith(QLatin1String("qt_")) // Qt's own mark
        || qobject_cast<const QAbstractSpinBox *>(parent)       // its line
        || qobject_cast<const QComboBox *>(parent)              // its line and its list
        || (name.startsWith("QComboBox") && name != "QComboBox") || qobject_cast<const QScrollBar *>(&widget)
        || (qobject_cast<const QLabel *>(&widget) && widget.focusPolicy() == Qt::ClickFocus) // selected by the mouse only
        || (qobject_cast<const QHeaderView *>(&widget) && qobject_cast<const QAbstractItemView *>(parent))
        || (qobject_cast<const QTabBar *>(&widget) && qobject_cast<const QMainWindow *>(parent)); // of docks: each tab has one
}

QString nameOf(QWidget &widget)
{
    if (!widget.accessibleName().isEmpty())
        return widget.accessibleName();
    if (qobject_cast<const QComboBox *>(&widget)) { // Qt gives the chosen text as the name; the label is the relation
        for (const auto *label : widget.window()->findChildren<QLabel *>())
            if (label->buddy() == &widget)
                return label->text();
        return {};
    }
    QAccessibleInterface *accessible = QAccessible::queryAccessibleInterface(&widget);
    return accessible ? accessible->text(QAccessible::Name) : QString();
}

/// From the window down: object names, and classes of what has none.
QString pathOf(const QWidget &widget)
{
    QStringList path;
    for (const QWidget *at = &widget; at; at = at->isWindow() ? nullptr : at->parentWidget())
        path.prepend(at->objectName().isEmpty() ? QLatin1String(at->metaObject()->className()) : at->objectName());
    return path.join(QLatin1Char('/'));
}

/// The dialog, dock or part of the window that a control is in.
const QWidget *placeOf(const QWidget &widget)
{
    const QWidget *at = &widget;
    while (!at->isWindow() && !qobject_cast<const QDockWidget *>(at) && !qobject_cast<const QToolBar *>(at)
           && at->parentWidget())
        at = at->parentWidget();
    return at;
}

/// What is wrong in `root` and its widgets, but for the windows in it.
QStringList faultsIn(QWidget &root)
{
    QStringList faults;
    QHash<std::pair<const QWidget *, QString>, const QWidget *> named;
    for (QWidget *widget : root.findChildren<QWidget *>()) {
        if (widget->focusPolicy() == Qt::NoFocus || isPieceOfQt(*widget) || qobject_cast<QMenu *>(widget))
            continue;
        if (qobject_cast<QAbstractButton *>(widget) && widget->isHidden())
            continue; // it may get its text when it is shown, as it is in another state
        const QString name = nameOf(*widget).trimmed();
        const QString what = QLatin1String(widget->metaObject()->className()) + QLatin1Char(' ') + pathOf(*widget);
        if (name.isEmpty())
            faults << QStringLiteral("no name: ") + what;
        if (name.isEmpty() || !widget->isVisible())
            continue;
        const QWidget *&first = named[{placeOf(*widget), name}];
        if (first)
            faults << QStringLiteral("\"%1\" is the name of %2 and of %3").arg(name, what, pathOf(*first));
        first = widget;
    }
    return faults;
}

QStringList namelessEntriesIn(const QMenu &menu)
{
    QStringList faults;
    for (const QAction *action : menu.actions()) {
        if (!action->isSeparator() && action->text().trimmed().isEmpty())
            faults << QStringLiteral("no text: ") + menu.objectName() + QLatin1Char('/') + action->objectName();
    }
    return faults;
}

} // namespace

class AccessibleNamesTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init() { setUpWithDemo(); }
    void cleanup() { tearDown(); }

    void windowHasNames_data() { addWindowStates(); }
    void windowHasNames()
    {
        QFETCH(QString, state);
        enter(state);
        const QStringList faults = faultsIn(*m_window);
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char('\n'))));
    }

    void dialogsHaveNames_data()
    {
        QTest::addColumn<QString>("state");
        for (const QString &state : dialogStates())
            QTest::newRow(qPrintable(state)) << state;
    }
    void dialogsHaveNames()
    {
        QFETCH(QString, state);
        const std::unique_ptr<QWidget> dialog(opened(state));
        QVERIFY(dialog->isVisible());
        QVERIFY(!dialog->windowTitle().isEmpty());
        const QStringList faults = faultsIn(*dialog);
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char('\n'))));
    }

    void questionHasNames()
    {
        m_station->showSealed(1);
        find<QAction>("actionLand")->trigger();
        const QStringList faults = faultsIn(*find<QDialog>("confirmCommand"));
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char('\n'))));
    }

    void entriesOfMenusHaveNames()
    {
        m_station->showSealed(1);
        auto *map = m_window->findChild<MapView *>();
        QContextMenuEvent click(QContextMenuEvent::Mouse, map->rect().center(), map->mapToGlobal(map->rect().center()));
        QCoreApplication::sendEvent(map, &click);
        QVERIFY(m_window->findChild<QMenu *>(QStringLiteral("mapMenu")));
        QStringList faults;
        int menus = 0;
        for (QMenu *menu : m_window->findChildren<QMenu *>()) {
            Q_EMIT menu->aboutToShow();
            faults << namelessEntriesIn(*menu);
            ++menus;
        }
        QVERIFY(menus > 8);
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char('\n'))));
    }

    /// A new class of dialogs is forgotten neither here nor by those who look at the pictures.
    void everyClassOfDialogsIsOpened()
    {
        QSet<QString> opens;
        for (const QString &state : dialogStates()) {
            const std::unique_ptr<QWidget> dialog(opened(state));
            for (const QMetaObject *type = dialog->metaObject(); type; type = type->superClass())
                opens.insert(QString::fromLatin1(type->className()).section(QStringLiteral("::"), -1));
        }
        static const QRegularExpression kDialog(QStringLiteral("^class (\\w+)(?: final)? : public \\w*Dialog\\b"));
        QStringList missing;
        int classes = 0;
        QDirIterator headers(QStringLiteral(SKYSEAL_SOURCE_DIR "/ui"), {QStringLiteral("*.h")}, QDir::Files,
                             QDirIterator::Subdirectories);
        while (headers.hasNext()) {
            QFile file(headers.next());
            QVERIFY(file.open(QIODevice::ReadOnly));
            for (const QString &line : QString::fromUtf8(file.readAll()).split(QLatin1Char('\n'))) {
                const auto match = kDialog.match(line);
                if (!match.hasMatch())
                    continue;
                ++classes;
                if (!opens.contains(match.captured(1)))
                    missing << match.captured(1) + QStringLiteral(" is not in gallery_dialogs.cpp");
            }
        }
        QVERIFY(classes >= 18);
        QVERIFY2(missing.isEmpty(), qPrintable(missing.join(QLatin1Char('\n'))));
    }

    /// Else the walk above would pass over everything.
    void faultsAreFound()
    {
        QDialog dialog;
        auto *named = new QSpinBox(&dialog);
        named->setAccessibleName(QStringLiteral("Altitude"));
        auto *nameless = new QComboBox(&dialog);
        nameless->addItem(QStringLiteral("chosen"));
        nameless->setObjectName(QStringLiteral("probe"));
        auto *other = new QSpinBox(&dialog);
        other->setAccessibleName(QStringLiteral("Altitude"));
        dialog.show();
        const QStringList faults = faultsIn(dialog);
        QCOMPARE(faults.size(), qsizetype(2));
        QVERIFY2(faults[0].contains(QStringLiteral("QComboBox")) && faults[0].contains(QStringLiteral("probe")),
                 qPrintable(faults[0]));
        QVERIFY2(faults[1].contains(QStringLiteral("Altitude")), qPrintable(faults[1]));
    }

private:
    void enter(const QString &state) { enterState(state, *m_window, *m_station); }
    QWidget *opened(const QString &state)
    {
        m_keyring = std::make_unique<FakeKeyring>();
        m_pairing = std::make_unique<FakePairing>();
        fillKeyring(*m_keyring);
        return openDialog(state, *m_window, *m_keyring, *m_pairing);
    }

    std::unique_ptr<FakeKeyring> m_keyring;
    std::unique_ptr<FakePairing> m_pairing;
};

SKYSEAL_TEST_WIDGETS(AccessibleNamesTest)
#include "accessible_names_test.moc"
