// The grid of values by real input: a field is found and added by keys, a limit is a word, what is stored survives and what is
// damaged is refused with a reason, and digits and columns follow the room.
#include "scripted_snapshots.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/alerts/alert_row.h"
#include "ui/values/cell_area.h"
#include "ui/sparkline.h"
#include "ui/values/value_cell.h"
#include "ui/values/values_editor.h"
#include "ui/values/values_grid.h"
#include "window_rig.h"

#include <QtGui/QAction>
#include <QtGui/QImage>
#include <QtGui/QPainter>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSpinBox>
#include <QtWidgets/QToolButton>

using namespace skyseal;
using namespace skyseal::ui;

namespace {

engine::FieldChoice fieldOf(const QString &id)
{
    return findValueSource(id)->fieldChoice().value();
}

engine::FieldReading readingOf(const QString &id, double number, double age = 0.1, std::uint8_t component = 1)
{
    const engine::FieldChoice choice = fieldOf(id);
    return {choice, 1, component, mavlink::FieldValue::fromNumber(choice.field->type, number), age};
}

const QString kFix = QStringLiteral("GPS_RAW_INT.fix_type"), kSatellites = QStringLiteral("GPS_RAW_INT.satellites_visible"),
              kCell = QStringLiteral("BATTERY_STATUS.voltages[2]");

} // namespace

class ValuesTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void noteLeavesTheCaption()
    {
        ValueCell cell({.source = *findValueSource(QStringLiteral("flight_time"))}, nullptr);
        cell.resize(140, 42);
        cell.setRoom(18, 0);
        const auto caption = [&cell](const QString &note) {
            cell.showReading({.number = 3, .note = note, .age = 0}, UnitSystem::Metric);
            return cell.grab(QRect(0, 0, 34, cell.captionHeight())).toImage();
        };
        const QImage alone = caption({});
        QVERIFY(caption(QStringLiteral("a note that is longer than the cell is wide")) == alone);
        QVERIFY2(cell.toolTip().endsWith(QStringLiteral("is wide")), qPrintable(cell.toolTip()));
    }

    void fieldIsChosenByKeys()
    {
        openEditorByKeys();
        auto *typed = editor()->findChild<QLineEdit *>(QStringLiteral("editorFind"));
        QVERIFY(typed->hasFocus());
        QTest::keyClicks(typed, QStringLiteral("satellites gps_raw"));
        QTest::keyClick(typed, Qt::Key_Return);
        QCOMPARE(list()->count(), 11);
        QVERIFY2(list()->currentItem()->text().contains(QStringLiteral("GPS_RAW_INT.satellites_visible")),
                 qPrintable(list()->currentItem()->text()));
        QVERIFY(m_station->chosenFields.empty()); // nothing takes effect before Apply
        pressButton(Qt::Key_P, "editorApply");
        QCOMPARE(m_station->chosenFields, std::vector{fieldOf(kSatellites)});
        QCOMPARE(cell(kSatellites)->value(), dash());
        QVERIFY(cell(kSatellites)->note().isEmpty()); // it never came: it has no age
        showFields({readingOf(kSatellites, 14)});
        QCOMPARE(cell(kSatellites)->value(), QStringLiteral("14"));
    }

    void arrowsChooseAmongTheFound()
    {
        openEditorByKeys();
        auto *typed = editor()->findChild<QLineEdit *>(QStringLiteral("editorFind"));
        QTest::keyClicks(typed, QStringLiteral("attitude.roll"));
        QTest::keyClick(typed, Qt::Key_Down);
        QTest::keyClick(typed, Qt::Key_Return);
        QVERIFY2(list()->currentItem()->text().contains(QStringLiteral("ATTITUDE.rollspeed")),
                 qPrintable(list()->currentItem()->text()));
        // The unit of the definition and the one that is shown.
        const QString about = editor()->findChild<QLabel *>(QStringLiteral("editorSource"))->text();
        QVERIFY2(about.contains(QStringLiteral("rad/s, shown in °/s")) && about.contains(QStringLiteral("float")),
                 qPrintable(about));
    }

    void wordsThatNoNameHasAreSaid()
    {
        openEditorByKeys();
        const auto *said = editor()->findChild<QLabel *>(QStringLiteral("editorFoundEmpty"));
        QVERIFY(!said->isVisible());
        QTest::keyClicks(editor()->findChild<QLineEdit *>(QStringLiteral("editorFind")), QStringLiteral("zzz"));
        QVERIFY(said->isVisible() && said->text().contains(QStringLiteral("these words")));
    }

    void sourceWithoutAUnitTakesOne()
    {
        openEditorByKeys();
        auto *unit = editor()->findChild<QLineEdit *>(QStringLiteral("editorUnit"));
        QVERIFY(!unit->isEnabled()); // the altitude has its own
        QCOMPARE(unit->text(), QStringLiteral("m"));
        QTest::keyClicks(editor()->findChild<QLineEdit *>(QStringLiteral("editorFind")), QStringLiteral("satellites gps_raw"));
        QTest::keyClick(editor()->findChild<QLineEdit *>(QStringLiteral("editorFind")), Qt::Key_Return);
        QVERIFY(unit->isEnabled() && unit->text().isEmpty());
        press(Qt::Key_N);
        QCOMPARE(editor()->focusWidget(), static_cast<QWidget *>(unit));
        QTest::keyClicks(unit, QStringLiteral("pcs and more"));
        QCOMPARE(unit->text(), QStringLiteral("pcs and ")); // no longer than a cell can show
        pressButton(Qt::Key_P, "editorApply");
        showFields({readingOf(kSatellites, 14)});
        QCOMPARE(cell(kSatellites)->unit(), QStringLiteral("pcs and"));
        QCOMPARE(cell(kSatellites)->text(), QStringLiteral("14\u00a0pcs and"));
        editor()->close();
        open(); // it is stored
        showFields({readingOf(kSatellites, 15)});
        QCOMPARE(cell(kSatellites)->text(), QStringLiteral("15\u00a0pcs and"));
    }

    void unitsOfTheDefinitionFollowTheSystem()
    {
        const auto choice = [](const char *id) { return ValueChoice{.source = *findValueSource(QString::fromLatin1(id))}; };
        const auto shown = [&](const char *id, UnitSystem units) { return unitName(choice(id).shownUnit(), units); };
        QCOMPARE(shown("GLOBAL_POSITION_INT.alt", UnitSystem::Metric), QStringLiteral("m")); // sent in mm
        QCOMPARE(shown("GLOBAL_POSITION_INT.alt", UnitSystem::Imperial), QStringLiteral("ft"));
        QCOMPARE(shown("VFR_HUD.groundspeed", UnitSystem::Aviation), QStringLiteral("kt"));
        QCOMPARE(shown("BATTERY_STATUS.current_consumed", UnitSystem::Imperial), QStringLiteral("mAh"));
        ValueChoice named = choice("GLOBAL_POSITION_INT.alt");
        named.unitText = QStringLiteral("furlong"); // not the operator's to choose
        QCOMPARE(unitName(named.shownUnit(), UnitSystem::Metric), QStringLiteral("m"));
    }

    void limitIsAWord()
    {
        openEditorByKeys();
        QVERIFY(list()->currentRow() == 0); // the altitude
        press(Qt::Key_L);
        QTest::keyClicks(editor()->focusWidget(), QStringLiteral("5"));
        press(Qt::Key_H);
        QTest::keyClicks(editor()->focusWidget(), QStringLiteral("120,5"));
        pressButton(Qt::Key_P, "editorApply");
        auto snapshot = sealedSnapshot(1);
        const auto noteAt = [&](double altitude) {
            snapshot.time += 1;
            snapshot.vehicles.front().state.altitudeRelative = altitude;
            m_station->show(snapshot);
            return cell(QStringLiteral("alt_rel"))->note();
        };
        QCOMPARE(noteAt(120.4), QString());
        QCOMPARE(noteAt(120.6), QStringLiteral("▲ high"));
        QCOMPARE(cell(QStringLiteral("alt_rel"))->text(), QStringLiteral("120.6\u00a0m, ▲ high")); // what a screen reader says
        QCOMPARE(noteAt(5.1), QString());
        QCOMPARE(noteAt(4.9), QStringLiteral("▼ low"));
        QCOMPARE(noteAt(vehicle::kUnknown), QString());
    }

    void limitRaisesAnAlertOverTheMap()
    {
        openEditorByKeys();
        press(Qt::Key_H);
        QTest::keyClicks(editor()->focusWidget(), QStringLiteral("120"));
        pressButton(Qt::Key_P, "editorApply");
        auto snapshot = sealedSnapshot(1);
        const auto alertAt = [&](double altitude) {
            snapshot.time += 0.1;
            snapshot.vehicles.front().state.altitudeRelative = altitude;
            m_station->show(snapshot);
            const auto &first = find<AlertRow>("alertRow0")->alert();
            return first ? first->text : QString();
        };
        QCOMPARE(alertAt(130), QString()); // it may be an outlier
        EVENTUALLY_EQUAL(alertAt(130), QStringLiteral("alt high: 130.0\u00a0m"));
        m_window->activateWindow();
        QTest::mouseClick(find<AlertRow>("alertRow0")->button(), Qt::LeftButton);
        QCOMPARE(alertAt(131), QString()); // dismissed
    }

    void limitsAreInTheUnitsOfTheOperator()
    {
        m_store->setValue(QStringLiteral("view/units"), static_cast<int>(UnitSystem::Imperial));
        open();
        openEditorByKeys();
        press(Qt::Key_H);
        QTest::keyClicks(editor()->focusWidget(), QStringLiteral("400"));
        pressButton(Qt::Key_P, "editorApply");
        const ValueChoice &choice = m_window->settings().values.list.front();
        QVERIFY2(std::abs(*choice.high - 121.92) < 1e-6, qPrintable(QString::number(*choice.high, 'g', 12)));
        QCOMPARE(editor()->findChild<QLineEdit *>(QStringLiteral("editorHigh"))->text(), QStringLiteral("400"));
        auto snapshot = sealedSnapshot(1);
        snapshot.vehicles.front().state.altitudeRelative = 122;
        m_station->show(snapshot);
        QCOMPARE(cell(QStringLiteral("alt_rel"))->text(), QStringLiteral("400\u00a0ft, ▲ high"));
    }

    void unsoundLimitsAreNotTakenOver()
    {
        openEditorByKeys();
        const auto *ok = editor()->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok);
        const auto *problem = editor()->findChild<QLabel *>(QStringLiteral("editorProblem"));
        press(Qt::Key_L);
        QTest::keyClicks(editor()->focusWidget(), QStringLiteral("ten"));
        QVERIFY(!ok->isEnabled());
        QVERIFY2(problem->text().contains(QStringLiteral("\"ten\" is not a number")), qPrintable(problem->text()));
        QTest::keyClick(editor()->focusWidget(), Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(editor()->focusWidget(), QStringLiteral("10"));
        QVERIFY(ok->isEnabled());
        press(Qt::Key_H);
        QTest::keyClicks(editor()->focusWidget(), QStringLiteral("10"));
        QVERIFY(!ok->isEnabled());
        QVERIFY2(problem->text().contains(QStringLiteral("below")), qPrintable(problem->text()));
    }

    void orderIsChangedByKeys()
    {
        openEditorByKeys();
        QCOMPARE(captions().mid(0, 3), (QStringList{QStringLiteral("alt"), QStringLiteral("hdg"), QStringLiteral("speed")}));
        pressButton(Qt::Key_D, "editorDown");
        pressButton(Qt::Key_D, "editorDown");
        QCOMPARE(list()->currentRow(), 2);
        pressButton(Qt::Key_U, "editorUp");
        press(Qt::Key_V); // the list
        QTest::keyClick(editor()->focusWidget(), Qt::Key_Down);
        QTest::keyClick(editor()->focusWidget(), Qt::Key_Delete);
        QTest::keyClick(editor()->focusWidget(), Qt::Key_Home);
        pressButton(Qt::Key_R, "editorRemove");
        QTest::keyClick(editor(), Qt::Key_Return); // OK is the default
        EVENTUALLY(!editor());
        QCOMPARE(captions().mid(0, 2), (QStringList{QStringLiteral("alt"), QStringLiteral("home")}));
        QCOMPARE(captions().size(), 8);
    }

    void choicesSurviveARestart()
    {
        openEditorByKeys();
        add(QStringLiteral("battery_status.voltages"));
        press(Qt::Key_E);
        QTest::keyClick(editor()->focusWidget(), Qt::Key_Up);
        QTest::keyClick(editor()->focusWidget(), Qt::Key_Up);
        press(Qt::Key_C);
        QTest::keyClicks(editor()->focusWidget(), QStringLiteral("third cell"));
        press(Qt::Key_M);
        QTest::keyClick(editor()->focusWidget(), Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(editor()->focusWidget(), QStringLiteral("3"));
        press(Qt::Key_L);
        QTest::keyClicks(editor()->focusWidget(), QStringLiteral("3.5"));
        pressButton(Qt::Key_I, "editorLine");
        pressButton(Qt::Key_P, "editorApply");
        m_store->sync();
        open();
        QCOMPARE(m_station->chosenFields, std::vector{fieldOf(kCell)});
        QCOMPARE(captions().last(), QStringLiteral("third cell"));
        QVERIFY(cell(kCell)->choice().line);
        showFields({readingOf(kCell, 3456)}); // millivolts
        QCOMPARE(cell(kCell)->text(), QStringLiteral("3.456\u00a0V, ▼ low"));
        showFields({readingOf(kCell, 65535)}); // "unknown" in the definition
        QCOMPARE(cell(kCell)->text(), dash() + QStringLiteral("\u00a0V"));
    }

    void cancelChangesNothing()
    {
        const QStringList before = captions();
        openEditorByKeys();
        pressButton(Qt::Key_R, "editorRemove");
        QTest::keyClick(editor(), Qt::Key_Escape);
        EVENTUALLY(!editor());
        QCOMPARE(captions(), before);
    }

    void damagedTextIsRefusedWithItsReason()
    {
        const QString stored = QStringLiteral("[{\"source\":\"alt_rel\"},{\"source\":\"NO_SUCH.field\"}]");
        m_store->setValue(QStringLiteral("view/values"), stored);
        open();
        const auto *problem = find<QLabel>("valuesProblem");
        QVERIFY(problem->isVisibleTo(m_window.get()));
        QVERIFY2(problem->text().contains(QStringLiteral("value 2: there is no value \"NO_SUCH.field\"")),
                 qPrintable(problem->text()));
        QCOMPARE(captions().size(), static_cast<int>(defaultValues().size()));
        // Another setting leaves it as it is, a choice replaces it.
        Settings changed = m_window->settings();
        changed.theme = Theme::Light;
        storeSettings(*m_store, changed);
        QCOMPARE(m_store->value(QStringLiteral("view/values")).toString(), stored);
        openEditorByKeys();
        pressButton(Qt::Key_P, "editorApply");
        QVERIFY(!problem->isVisibleTo(m_window.get()));
        QVERIFY(m_store->value(QStringLiteral("view/values")).toString() != stored);
    }

    void storedTextsAreChecked_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("reason");
        QTest::newRow("no JSON") << "alt_rel"
                                 << "not JSON";
        QTest::newRow("an object") << "{}"
                                   << "not a list";
        QTest::newRow("a number") << "[7]"
                                  << "value 1: there is no value";
        QTest::newRow("an element too many") << R"([{"source":"BATTERY_STATUS.voltages[10]"}])"
                                             << "there is no value";
        QTest::newRow("an array as a whole") << R"([{"source":"BATTERY_STATUS.voltages"}])"
                                             << "there is no value";
        QTest::newRow("a text") << R"([{"source":"STATUSTEXT.text[0]"}])"
                                << "there is no value";
        QTest::newRow("no caption") << R"([{"source":"alt","caption":3}])"
                                    << "\"caption\"";
        QTest::newRow("a long caption") << R"([{"source":"alt","caption":"1234567890123456789012345"}])"
                                        << "24 characters";
        QTest::newRow("decimals") << R"([{"source":"alt","decimals":10}])"
                                  << "\"decimals\"";
        QTest::newRow("limit") << R"([{"source":"alt","low":"5"}])"
                               << "\"low\" is not a number";
        QTest::newRow("limits") << R"([{"source":"alt","low":5,"high":5}])"
                                << "not below";
        QTest::newRow("line") << R"([{"source":"alt","line":1}])"
                              << "\"line\"";
        QTest::newRow("unit") << R"([{"source":"hdop","unit":3}])"
                              << "\"unit\"";
        QTest::newRow("a long unit") << R"([{"source":"hdop","unit":"123456789"}])"
                                     << "8 characters";
    }
    void storedTextsAreChecked()
    {
        QFETCH(const QString, text);
        QFETCH(const QString, reason);
        const auto read = readValueChoices(text);
        QVERIFY(!read);
        QVERIFY2(read.error().contains(reason), qPrintable(read.error()));
    }

    void everySourceIsFoundByItsName()
    {
        std::size_t numbers = 0;
        for (const ValueSource &source : valueSources()) {
            const auto again = findValueSource(source.id());
            QVERIFY2(again, qPrintable(source.id()));
            QCOMPARE(again->id(), source.id());
            QVERIFY2(!source.caption().isEmpty() && !source.title().isEmpty(), qPrintable(source.id()));
            QVERIFY2(!source.state || source.title() != source.id(), qPrintable(source.id())); // has words of its own
            numbers += source.isNumber();
        }
        QVERIFY(numbers > 1000);
        ValueChoices choices{{.source = *findValueSource(kCell),
                              .caption = QStringLiteral("c"),
                              .decimals = 0,
                              .low = -1.5,
                              .high = 2,
                              .line = true},
                             {.source = *findValueSource(QStringLiteral("mode"))}};
        QVERIFY(readValueChoices(toText(choices)) == choices);
    }

    void oldFieldTurnsGreyWithItsAge()
    {
        choose({{.source = *findValueSource(kFix)}});
        showFields({readingOf(kFix, mavlink::GPS_FIX_TYPE_RTK_FIXED, 3.4)});
        QCOMPARE(cell(kFix)->value(), QStringLiteral("RTK FIXED"));
        QVERIFY(!cell(kFix)->isStale() && cell(kFix)->note().isEmpty());
        showFields({readingOf(kFix, mavlink::GPS_FIX_TYPE_RTK_FIXED, 72)});
        QVERIFY(cell(kFix)->isStale());
        QCOMPARE(cell(kFix)->text(), QStringLiteral("RTK FIXED, 01:12"));
    }

    void fieldIsThatOfTheAutopilot()
    {
        choose({{.source = *findValueSource(kSatellites)}});
        showFields({readingOf(kSatellites, 5, 0.1, 220), readingOf(kSatellites, 17, 2, 1)});
        QCOMPARE(cell(kSatellites)->value(), QStringLiteral("17"));
        showFields({readingOf(kSatellites, 5, 2, 220), readingOf(kSatellites, 9, 1, 221)});
        QCOMPARE(cell(kSatellites)->value(), QStringLiteral("9")); // without one, the one heard last
    }

    void emptyGridSaysSo()
    {
        choose({});
        QVERIFY(find<QLabel>("valuesEmpty")->isVisibleTo(m_window.get()));
        QVERIFY(find<QToolButton>("editValues")->isVisibleTo(m_window.get()));
    }

    void menusOpenTheEditor()
    {
        find<QAction>("actionEditValues")->trigger();
        EVENTUALLY(editor());
        QVERIFY(!editor()->isModal());
        find<QAction>("actionEditValues")->trigger();
        QCOMPARE(m_window->findChildren<ValuesEditor *>().size(), 1); // the open one comes to the front
        const auto *grid = find<ValuesGrid>("valuesGrid");
        QCOMPARE(grid->parentWidget()->contextMenuPolicy(), Qt::ActionsContextMenu);
        QCOMPARE(grid->parentWidget()->actions().size(), 1);
        QCOMPARE(grid->parentWidget()->actions().first()->text(), QStringLiteral("Edit values…"));
    }

    void columnsAndDigitsGrowWithTheRoom()
    {
        CellArea area;
        area.setChoices(defaultValues());
        const int least = area.minimumSizeHint().width();
        area.resize(least, area.minimumSizeHint().height());
        area.show();
        QVERIFY(QTest::qWaitForWindowExposed(&area, test::kDeadlineMs));
        QCOMPARE(area.columns(), 2);
        area.resize(2 * least, area.height());
        QCOMPARE(area.columns(), 4);
        QCOMPARE(area.cells()[4]->pos().x(), 0);
        QVERIFY(area.cells()[4]->y() > 0 && area.cells()[3]->y() == 0);
        const auto inkOf = [&] { // of the digits of the first cell, below its caption
            const QImage image = area.cells()[0]->grab().toImage().convertToFormat(QImage::Format_Grayscale8);
            const int back = qGray(image.pixel(0, image.height() - 1));
            int ink = 0;
            for (int y = area.cells()[0]->captionHeight(); y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x)
                    ink += std::abs(qGray(image.pixel(x, y)) - back) > 60;
            }
            return ink;
        };
        area.cells()[0]->showReading({.number = 888.8, .age = 0}, UnitSystem::Metric);
        const int small = inkOf();
        area.resize(2 * least, 3 * area.height());
        QVERIFY2(inkOf() > small * 3 / 2, qPrintable(QStringLiteral("%1 %2").arg(small).arg(inkOf())));
    }

    void onlyRowsWithALineKeepRoomForIt()
    {
        ValueChoices choices = defaultValues();
        choices[3].line = true; // the second row of two columns
        CellArea area;
        area.setChoices(choices);
        area.show();
        area.resize(area.minimumSizeHint().width(), 1);
        area.resize(area.minimumSizeHint()); // of two columns
        QVERIFY(QTest::qWaitForWindowExposed(&area, test::kDeadlineMs));
        QCOMPARE(area.columns(), 2);
        const auto &cells = area.cells();
        QCOMPARE(cells[2]->height(), cells[0]->height() + ValueCell::kLineHeight);
        QCOMPARE(cells[3]->geometry().top(), cells[2]->geometry().top());
        QCOMPARE(cells[4]->geometry().top(), cells[2]->geometry().bottom() + 1);
        QCOMPARE(cells[4]->height(), cells[0]->height());
        QVERIFY(cells.back()->geometry().bottom() < area.height());
    }

    void lineShowsTheLastMinute()
    {
        Sparkline line;
        QVERIFY(line.isEmpty());
        QVERIFY(line.add(100, 0));
        QVERIFY(!line.add(100.1, 0)); // the same quarter of a second
        for (double time = 100; time < 160; time += 0.25)
            line.add(time, time - 100);
        const auto heightAt = [&](int x) { // of the ink in a column, from above; -1: none
            QImage image(240, 40, QImage::Format_RGB32);
            image.fill(Qt::white);
            QPainter painter(&image);
            line.paint(painter, QRectF(0, 2, 240, 36), Qt::black, 0);
            painter.end();
            for (int y = 0; y < image.height(); ++y) {
                if (qGray(image.pixel(x, y)) < 128)
                    return y;
            }
            return -1;
        };
        QVERIFY(heightAt(5) > 30 && heightAt(235) < 8 && heightAt(235) >= 0);
        line.add(190, 60); // half a minute without a sample is a gap, and what is older than a minute goes
        QCOMPARE(heightAt(180), -1);
        QVERIFY(heightAt(60) >= 0);
        line.add(20, 1); // the time went back
        QCOMPARE(heightAt(60), -1);
        line.clear();
        QVERIFY(line.isEmpty());
    }

    void lineOfTheGridFollowsTheSnapshots()
    {
        ValueChoices choices{{.source = *findValueSource(QStringLiteral("alt_rel")), .line = true}};
        choose(choices);
        m_window->repaint();
        const QImage without = cell(QStringLiteral("alt_rel"))->grab().toImage();
        for (double time = 1; time < 40; time += 0.25) {
            auto snapshot = sealedSnapshot(time);
            snapshot.vehicles.front().state.altitudeRelative = 10 + 5 * std::sin(time);
            m_station->show(snapshot);
        }
        const auto bottomOf = [](const QImage &image) {
            return image.copy(0, image.height() - ValueCell::kLineHeight, image.width(), ValueCell::kLineHeight);
        };
        const QImage with = cell(QStringLiteral("alt_rel"))->grab().toImage();
        QVERIFY(bottomOf(without) != bottomOf(with));
        auto other = sealedSnapshot(40);
        other.vehicles.front().state.systemId = 9;
        other.vehicles.front().state.altitudeRelative = vehicle::kUnknown;
        m_station->show(other);
        QVERIFY(bottomOf(cell(QStringLiteral("alt_rel"))->grab().toImage()) == bottomOf(without)); // another vehicle's
    }

private:
    ValuesEditor *editor() const
    {
        for (auto *dialog : m_window->findChildren<ValuesEditor *>()) {
            if (dialog->isVisible())
                return dialog;
        }
        return nullptr;
    }

    QListWidget *list() const { return editor()->findChild<QListWidget *>(QStringLiteral("editorList")); }
    ValueCell *cell(const QString &id) const { return find<ValueCell>(("value_" + id.toUtf8()).constData()); }

    QStringList captions() const
    {
        QStringList out;
        for (const ValueCell *shown : m_window->findChild<CellArea *>()->cells())
            out << shown->accessibleName();
        return out;
    }

    void openEditorByKeys()
    {
        auto *button = find<QToolButton>("editValues");
        button->setFocus();
        QTest::keyClick(button, Qt::Key_Space);
        EVENTUALLY(editor());
        EVENTUALLY(QApplication::activeWindow() == editor()); // else the mnemonics are those of the window
    }

    /// Alt and a letter, in the editor.
    void press(Qt::Key letter) { QTest::keyClick(editor(), letter, Qt::AltModifier); }

    /// Alt and the letter of a button, which is clicked a moment later.
    void pressButton(Qt::Key letter, const char *name)
    {
        auto *button = editor()->findChild<QAbstractButton *>(QLatin1String(name));
        QSignalSpy clicks(button, &QAbstractButton::clicked);
        press(letter);
        EVENTUALLY(clicks.count() == 1);
    }

    void add(const QString &name)
    {
        press(Qt::Key_F);
        QTest::keyClicks(editor()->focusWidget(), name);
        QTest::keyClick(editor()->focusWidget(), Qt::Key_Return);
    }

    /// As stored before the start.
    void choose(const ValueChoices &choices)
    {
        m_store->setValue(QStringLiteral("view/values"), toText(choices));
        open();
    }

    void showFields(std::vector<engine::FieldReading> readings)
    {
        m_time += 1;
        auto snapshot = sealedSnapshot(m_time);
        snapshot.fields = std::move(readings);
        m_station->show(snapshot);
    }

    double m_time = 1;
};

SKYSEAL_TEST_WIDGETS(ValuesTest)
#include "values_test.moc"
