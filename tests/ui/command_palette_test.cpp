// The palette finds every entry of the menus by parts of its name, says why one is not possible, and chooses one by keys alone.
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "window_rig.h"

#include <QtGui/QAction>
#include <QtGui/QStandardItemModel>
#include <QtTest/QTest>
#include <QtWidgets/QDialog>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QTreeView>

using namespace skyseal;
using namespace skyseal::ui;

class CommandPaletteTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void keysFindAndChoose()
    {
        openPalette();
        type(QStringLiteral("zoom lab")); // no entry has these words
        QCOMPARE(shown(), QStringList());
        QVERIFY(find<QLabel>("paletteNone")->isVisible());
        QCOMPARE(find<QLabel>("paletteNone")->text(), QStringLiteral("No command matches"));
        clear();
        QVERIFY(!find<QLabel>("paletteNone")->isVisible());
        type(QStringLiteral("view LAB"));
        QCOMPARE(shown(), QStringList{QStringLiteral("View › Lab")});
        QTest::keyClick(typed(), Qt::Key_Return);
        EVENTUALLY(find<QAction>("workspace_lab")->isChecked());
        EVENTUALLY(!palette());
    }

    void everyEntryIsThere()
    {
        openPalette();
        const QStringList all = shown();
        int entries = 0;
        for (const QAction *top : m_window->menuBar()->actions()) {
            for (const QAction *action : top->menu()->actions()) {
                if (action->isSeparator())
                    continue;
                ++entries;
                QString text = action->text();
                text.remove(QLatin1Char('&'));
                QVERIFY2(std::ranges::any_of(all, [&](const QString &name) { return name.contains(text); }), qPrintable(text));
            }
        }
        QVERIFY(entries > 30);
    }

    void impossibleEntriesSayWhy()
    {
        openPalette();
        type(QStringLiteral("vehicle land"));
        QCOMPARE(shown(), QStringList{QStringLiteral("Vehicle › Land…")});
        const auto *model = qobject_cast<QStandardItemModel *>(list()->model());
        const int row = rowOf(QStringLiteral("Vehicle › Land…"));
        QVERIFY(!model->item(row)->isEnabled());
        QVERIFY2(model->item(row, 1)->text().contains(QStringLiteral("vehicle"), Qt::CaseInsensitive),
                 qPrintable(model->item(row, 1)->text()));
        QTest::keyClick(typed(), Qt::Key_Return);
        QVERIFY(palette()); // nothing was chosen
        QVERIFY(m_station->commands.empty());
        QTest::keyClick(typed(), Qt::Key_Escape);
        EVENTUALLY(!palette());
    }

    void commandsThatMakeNoSenseNowSayWhy()
    {
        m_station->showSealed(1, [](auto &state) { state.armed = false; });
        openPalette();
        const auto *model = qobject_cast<QStandardItemModel *>(list()->model());
        const auto reason = [&](const char *name) { return model->item(rowOf(QString::fromUtf8(name)), 1)->text(); };
        QCOMPARE(reason("Vehicle › Disarm…"), QStringLiteral("Not now: the vehicle is disarmed"));
        QVERIFY2(reason("Vehicle › Pause…").startsWith(QStringLiteral("Not now: ")), qPrintable(reason("Vehicle › Pause…")));
        QVERIFY(model->item(rowOf(QStringLiteral("Vehicle › Land…")))->isEnabled());
    }

    void clickOnAnImpossibleEntryDoesNothing()
    {
        m_station->showSealed(1); // armed
        openPalette();
        type(QStringLiteral("vehicle arm"));
        const int arm = rowOf(QStringLiteral("Vehicle › Arm…"));
        QVERIFY(!qobject_cast<QStandardItemModel *>(list()->model())->item(arm)->isEnabled());
        QVERIFY(list()->currentIndex().isValid() && list()->currentIndex().row() != arm);
        list()->scrollTo(list()->model()->index(arm, 0));
        QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, list()->visualRect(list()->model()->index(arm, 0)).center());
        QVERIFY(palette() && palette()->isVisible());
        QVERIFY(!m_window->findChild<QMessageBox *>());
    }

    void submenusAreFilled()
    {
        m_station->showSealed(1);
        openPalette();
        type(QStringLiteral("mode"));
        QVERIFY2(shown().contains(QStringLiteral("Vehicle › Mode › GUIDED…")), qPrintable(shown().join(QLatin1Char('\n'))));
    }

    void arrowsMoveWhileOneTypes()
    {
        openPalette();
        type(QStringLiteral("zoom"));
        QCOMPARE(shown().size(), qsizetype(2));
        const int before = list()->currentIndex().row();
        QTest::keyClick(typed(), Qt::Key_Down);
        QCOMPARE(list()->currentIndex().row(), rowOf(shown().last()));
        QVERIFY(list()->currentIndex().row() != before);
        QCOMPARE(palette()->focusWidget(), typed());
    }

    void oneIsOpenAtMost()
    {
        openPalette();
        QPointer<QDialog> first = palette();
        find<QAction>("actionPalette")->trigger();
        QCOMPARE(m_window->findChildren<QDialog *>(QStringLiteral("commandPalette")).size(), qsizetype(1));
        QVERIFY(first);
    }

private:
    void openPalette()
    {
        QTest::keyClick(m_window.get(), Qt::Key_K, Qt::ControlModifier);
        EVENTUALLY(palette() && palette()->isVisible());
    }
    QDialog *palette() const { return m_window->findChild<QDialog *>(QStringLiteral("commandPalette")); }
    QLineEdit *typed() const { return find<QLineEdit>("paletteTyped"); }
    QTreeView *list() const { return find<QTreeView>("paletteList"); }
    void type(const QString &text) { QTest::keyClicks(typed(), text); }
    void clear() { typed()->clear(); }
    int rowOf(const QString &name) const
    {
        for (int row = 0; row < list()->model()->rowCount(); ++row)
            if (list()->model()->index(row, 0).data().toString() == name)
                return row;
        return -1;
    }
    QStringList shown() const
    {
        QStringList names;
        for (int row = 0; row < list()->model()->rowCount(); ++row)
            if (!list()->isRowHidden(row, {}))
                names << list()->model()->index(row, 0).data().toString();
        return names;
    }
};

SKYSEAL_TEST_WIDGETS(CommandPaletteTest)
#include "command_palette_test.moc"
