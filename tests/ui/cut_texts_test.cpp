// No dialog cuts a text, in either language and any colours, and what is longer than its box ends with an ellipsis.
#include "cut_texts.h"
#include "gallery_dialogs.h"
#include "scripted_snapshots.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/language.h"
#include "ui/vehicles/vehicle_list_row.h"
#include "window_rig.h"

#include <QtGui/QHelpEvent>
#include <QtGui/QStandardItemModel>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QRadioButton>
#include <QtWidgets/QToolTip>
#include <QtWidgets/QTreeView>

using namespace skyseal;
using namespace skyseal::ui;

class CutTextsTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { tearDown(); }

    void noDialogCutsAText_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("name");
        QTest::addColumn<Theme>("theme");
        for (const char *language : {"en", "de"})
            for (const QString &name : dialogStates())
                for (const Theme theme : {Theme::Light, Theme::Dark})
                    QTest::addRow("%s %s %s", qPrintable(name), language, theme == Theme::Light ? "light" : "dark")
                        << QString::fromLatin1(language) << name << theme;
    }

    void noDialogCutsAText()
    {
        QFETCH(QString, language);
        QFETCH(QString, name);
        QFETCH(Theme, theme);
        const WindowTranslation translation(language);
        setUp();
        applyTheme(theme);
        m_station->show(sealedSnapshot(1));
        FakeKeyring keyring;
        FakePairing pairing;
        fillKeyring(keyring);
        const std::unique_ptr<QWidget> dialog(openDialog(name, *m_window, keyring, pairing));
        QVERIFY(QTest::qWaitForWindowExposed(dialog.get(), test::kDeadlineMs));
        QCoreApplication::processEvents();
        for (const QWidget *widget : dialog->findChildren<QWidget *>()) {
            if (!widget->isVisible())
                continue;
            const QString cut = cutTextOf(*widget);
            QVERIFY2(cut.isEmpty(), qPrintable(widget->objectName() + QStringLiteral(": ") + cut));
            if (!isLabelled(*widget))
                continue;
            const auto *label = qobject_cast<const QLabel *>(widget);
            const QSize wanted = label && label->wordWrap() ? QSize(0, label->heightForWidth(label->width()))
                                                            : widget->sizeHint();
            const QString what = QStringLiteral("%1 %2x%3 of %4x%5: %6")
                                     .arg(widget->objectName())
                                     .arg(widget->width())
                                     .arg(widget->height())
                                     .arg(wanted.width())
                                     .arg(wanted.height())
                                     .arg(widget->property("text").toString());
            const int spare = widget->fontMetrics().descent(); // lines have more height than their letters
            QVERIFY2(widget->width() + 1 >= wanted.width() && widget->height() + spare >= wanted.height(), qPrintable(what));
        }
    }

    void choiceThatIsTooLongIsElided()
    {
        applyTheme(Theme::Light);
        const QString text = QStringLiteral("921,600 baud · saturated load");
        QComboBox box, elided;
        for (QComboBox *one : {&box, &elided}) {
            one->setMinimumWidth(1);
            one->resize(140, 28);
            one->ensurePolished();
        }
        box.addItem(text);
        QVERIFY(isChoiceCut(box));
        elided.addItem(box.fontMetrics().elidedText(text, Qt::ElideRight, roomOf(box)));
        QVERIFY(elided.currentText().endsWith(QChar(0x2026)));
        QVERIFY(box.grab().toImage() == elided.grab().toImage());

        box.show();
        QVERIFY(QTest::qWaitForWindowExposed(&box, test::kDeadlineMs));
        QHelpEvent hover(QEvent::ToolTip, {5, 5}, box.mapToGlobal(QPoint(5, 5)));
        QCoreApplication::sendEvent(&box, &hover);
        QVERIFY2(QToolTip::text().contains(text), qPrintable(QToolTip::text()));
        QToolTip::hideText();
    }

    /// Also of the selected vehicle, which is bold.
    void lockOfAVehicleIsWhole_data()
    {
        QTest::addColumn<QString>("language");
        QTest::newRow("English") << QStringLiteral("en");
        QTest::newRow("German") << QStringLiteral("de");
    }
    void lockOfAVehicleIsWhole()
    {
        QFETCH(QString, language);
        const WindowTranslation translation(language);
        setUp();
        m_station->show(sealedSnapshot(1));
        auto *list = find<QTreeView>("vehicleList");
        find<QDockWidget>("dockVehicles")->raise();
        EVENTUALLY(list->isVisible() && list->model()->rowCount() == 1);
        const int lock = VehicleListRow::Lock;
        const QModelIndex cell = list->model()->index(0, lock);
        QVERIFY2(list->header()->sectionSize(lock) >= list->sizeHintForIndex(cell).width(), qPrintable(cell.data().toString()));
    }

    /// In the palette the name of a command is as long as its reason.
    void reasonsOfThePaletteAreWhole()
    {
        setUp();
        engine::Snapshot unread = sealedSnapshot(1);
        unread.vehicles.front().mission = nullptr;
        m_station->show(unread);
        QTest::keyClick(m_window.get(), Qt::Key_K, Qt::ControlModifier);
        EVENTUALLY(m_window->findChild<QTreeView *>(QStringLiteral("paletteList")));
        const auto *list = find<QTreeView>("paletteList");
        EVENTUALLY(list->isVisible());
        int reasons = 0;
        for (int row = 0; row < list->model()->rowCount(); ++row) {
            const QModelIndex reason = list->model()->index(row, 1);
            if (reason.flags() & Qt::ItemIsEnabled)
                continue;
            ++reasons;
            const int wanted = list->fontMetrics().horizontalAdvance(reason.data().toString());
            QVERIFY2(wanted <= list->header()->sectionSize(1), qPrintable(reason.data().toString()));
        }
        QVERIFY(reasons > 0);
    }

private:
    static bool isLabelled(const QWidget &widget)
    {
        const auto *label = qobject_cast<const QLabel *>(&widget);
        return label ? !label->text().isEmpty() && label->sizePolicy().horizontalPolicy() != QSizePolicy::Ignored
                     : qobject_cast<const QPushButton *>(&widget) || qobject_cast<const QRadioButton *>(&widget)
                || qobject_cast<const QCheckBox *>(&widget);
    }

    static int roomOf(const QComboBox &box)
    {
        QStyleOptionComboBox option;
        option.initFrom(&box);
        option.subControls = QStyle::SC_All;
        option.frame = box.hasFrame();
        return box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box).width() - 2;
    }
};

SKYSEAL_TEST_WIDGETS(CutTextsTest)
#include "cut_texts_test.moc"
