// At every size and in every state, in each language: no text is cut, nothing lies over anything else, and changing numbers
// move nothing.
#include "core/vehicle/reasons.h"
#include "cut_texts.h"
#include "fake_station.h"
#include "scripted_snapshots.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/charts/chart.h"
#include "ui/charts/chart_grid.h"
#include "ui/charts/diagnostics_panel.h"
#include "ui/fitting_scroll.h"
#include "ui/language.h"
#include "ui/result_label.h"
#include "ui/flight/hold_button.h"
#include "ui/flight/horizon.h"
#include "ui/flight/tape.h"
#include "ui/flight/vehicle_commands.h"
#include "ui/window/main_window.h"
#include "ui/window/workspace_table.h"
#include "ui/security/counters_table.h"
#include "ui/status/status_strip.h"
#include "ui/status/strip_item.h"
#include "ui/text/figures.h"

#include <QtCore/QSettings>
#include <QtCore/QTemporaryDir>
#include <QtGui/QAction>
#include <QtGui/QPainter>
#include <QtTest/QTest>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QDockWidget>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QRadioButton>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QToolButton>

using namespace skyseal;
using namespace skyseal::ui;

class LayoutTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingIsCut_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<QString>("state");
        QTest::addColumn<QByteArray>("workspace");
        QTest::addColumn<QString>("language");
        QTest::addColumn<bool>("contrast");
        const auto rows = [](const QSize &size, const char *language, bool contrast) {
            for (const char *state : {"waiting", "plain", "sealed", "attack"})
                for (const WorkspaceRow &row : workspaceTable())
                    QTest::addRow("%dx%d %s %s %s%s", size.width(), size.height(), state, row.id, language,
                                  contrast ? " high contrast" : "")
                        << size << QString::fromLatin1(state) << QByteArray(row.id) << QString::fromLatin1(language)
                        << contrast;
        };
        for (const QSize size : {QSize(1024, 768), QSize(1366, 768)}) // each button names its vehicle
            for (const char *language : {"en", "de"})
                QTest::addRow("%dx%d several fly %s", size.width(), size.height(), language)
                    << size << QStringLiteral("several") << QByteArray("fly") << QString::fromLatin1(language) << false;
        for (const QSize size : {QSize(1024, 700), QSize(1280, 800), QSize(1366, 768), QSize(1920, 1080), QSize(2560, 1440)})
            rows(size, "en", false);
        for (const QSize size : {QSize(1024, 700), QSize(1366, 768)})
            rows(size, "de", false);
        for (const char *language : {"en", "de"})
            rows({1024, 700}, language, true);
    }

    void nothingIsCut()
    {
        QFETCH(QSize, size);
        QFETCH(QString, state);
        QFETCH(QByteArray, workspace);
        QFETCH(QString, language);
        QFETCH(bool, contrast);
        const WindowTranslation translation(language);
        open(size, workspace.constData(), contrast ? Theme::HighContrast : Theme::Light);
        show(state);
        QCoreApplication::processEvents();
        QCOMPARE(m_window->size(), size);
        for (const QWidget *widget : m_window->findChildren<QWidget *>()) {
            if (!widget->isVisible())
                continue;
            const bool isSeen = size.width() >= 1366 && !widget->visibleRegion().isEmpty(); // not behind another tab
            if (const QString cut = isSeen ? cutTextOf(*widget) : QString(); !cut.isEmpty())
                QFAIL(qPrintable(widget->objectName() + QStringLiteral(": ") + cut));
            if (!needsItsRoom(widget))
                continue;
            const QSize wanted = qobject_cast<const QLabel *>(widget) && static_cast<const QLabel *>(widget)->wordWrap()
                ? QSize(0, widget->heightForWidth(widget->width()))
                : widget->sizeHint();
            const QByteArray what = (QLatin1String(widget->metaObject()->className()) + QLatin1Char(' ') + widget->objectName()
                                     + QStringLiteral(" \"%1\"").arg(widget->property("text").toString()))
                                        .toUtf8();
            QVERIFY2(widget->width() + 1 >= wanted.width(), what.constData());
            QVERIFY2(widget->height() + 1 >= wanted.height(), what.constData());
            QVERIFY2(!overlaps(widget), what.constData());
        }
        if (size.width() < 1280)
            return; // the docks are at their least width
        for (const QScrollArea *area : m_window->findChildren<FittingScroll *>())
            EVENTUALLY2(area->widget()->width() <= area->viewport()->width(), qPrintable(area->parentWidget()->objectName()));
    }

    void scaleIsThatOfTheScreen()
    {
        open({1366, 768}, "fly");
        show(QStringLiteral("sealed"));
        const double scale = qEnvironmentVariable("QT_SCALE_FACTOR", QStringLiteral("1")).toDouble();
        QCOMPARE(m_window->devicePixelRatioF(), scale);
        QCOMPARE(m_window->grab().size(), (QSizeF(1366, 768) * scale).toSize());
    }

    void titlesOfTheChartsAreWhole()
    {
        open({1280, 800});
        show(QStringLiteral("sealed"));
        int charts = 0;
        for (const auto *chart : m_window->findChildren<TimeSeriesChart *>()) {
            if (!chart->isVisible())
                continue;
            ++charts;
            for (const QLabel *label : chart->findChildren<QLabel *>())
                QVERIFY2(!label->text().contains(QChar(0x2026)), qPrintable(label->text()));
        }
        QCOMPARE(charts, 3);
    }

    void sidesFitWithoutScrolling_data()
    {
        QTest::addColumn<QString>("state");
        for (const char *state : {"waiting", "plain", "sealed", "attack"})
            QTest::newRow(state) << QString::fromLatin1(state);
    }

    void sidesFitWithoutScrolling()
    {
        QFETCH(QString, state);
        for (const QSize size : {QSize(1024, 700), QSize(1280, 800)}) {
            for (const char *workspace : {"fly", "lab"}) {
                open(size, workspace);
                show(state);
                for (const QScrollArea *area : m_window->findChildren<FittingScroll *>())
                    EVENTUALLY2(!area->verticalScrollBar()->isVisible(), qPrintable(area->parentWidget()->objectName()));
            }
        }
    }

    void chartsFillTheirDock()
    {
        for (const QSize size : {QSize(1024, 700), QSize(1280, 800), QSize(1440, 900), QSize(2560, 1440)}) {
            open(size);
            show(QStringLiteral("sealed"));
            const auto *panel = m_window->findChild<DiagnosticsPanel *>();
            const auto *grid = panel->findChild<ChartGrid *>();
            for (int i = 0; i < panel->chartCount(); ++i)
                EVENTUALLY2(panel->chart(i)->height() <= grid->viewport()->height()
                                && panel->chart(i)->height() >= grid->viewport()->height() - 2,
                            qPrintable(QStringLiteral("%1x%2: %3 in %4")
                                           .arg(size.width())
                                           .arg(size.height())
                                           .arg(panel->chart(i)->height())
                                           .arg(grid->viewport()->height())));
        }
    }

    void hiddenPartsStayInToolTips()
    {
        open({1024, 700});
        auto *dock = m_window->findChild<QDockWidget *>(QStringLiteral("dockSecure"));
        dock->setFloating(true);
        dock->resize(260, 400);
        engine::Snapshot snapshot = sealedSnapshot(1);
        snapshot.sessions.front().stats.rx.forged = 7;
        snapshot.sessions.front().stats.rx.malformed = 5;
        m_station->show(snapshot);
        const auto *counters = m_window->findChild<CountersTable *>();
        EVENTUALLY(counters->isBrief());
        const auto *refused = m_window->findChild<FigureLabel *>(QStringLiteral("counter_9_1"));
        QVERIFY(refused->isVisible());
        QCOMPARE(refused->value(), QStringLiteral("12"));
        QVERIFY(refused->toolTip().contains(QStringLiteral("7 forged")));
        QVERIFY(!m_window->findChild<QLabel *>(QStringLiteral("secureFingerprint"))->isVisible());
        QVERIFY(m_window->findChild<QLabel *>(QStringLiteral("securePeer"))->toolTip().contains(QStringLiteral("41c0 9be7")));
        const QString link = m_window->findChild<StripItem *>(QStringLiteral("stripLink"))->toolTip(); // labels of its numbers
        for (const char *label : {" of the frames arrived", " latency", " since the newest message"})
            QVERIFY2(link.contains(QLatin1String(label)), qPrintable(link));
        dock->resize(260, 900);
        EVENTUALLY(m_window->findChild<QLabel *>(QStringLiteral("secureFingerprint"))->isVisible());
        QVERIFY(!counters->isBrief());
        QVERIFY(!refused->isVisible());
    }

    void tapesCutNoNumber()
    {
        const TapeStyle style{Qt::black, Qt::red, Qt::blue, Qt::black};
        for (int height = 90; height < 140; height += 7) {
            for (double value = 0; value < 6; value += 0.1) {
                QImage image(52, height, QImage::Format_RGB32);
                QPainter painter(&image);
                paintVerticalTape(painter, image.rect(), value, 2, 11, 1, true, style);
                painter.end();
                for (const int y : {0, height - 1})
                    for (int x = 0; x < 40; ++x)
                        QVERIFY2(qRed(image.pixel(x, y)) < 40,
                                 qPrintable(QStringLiteral("value %1, height %2").arg(value).arg(height)));
            }
        }
    }

    /// A number beyond the type of the marks would be an overflow, which the sanitizers report, and endless on some machines.
    void tapesBearAnyNumber()
    {
        const TapeStyle style{Qt::black, Qt::red, Qt::blue, Qt::black};
        for (const double value : {1e30, -1e30, 1e308, qInf(), -qInf(), qQNaN(), 1e7}) {
            QImage image(52, 100, QImage::Format_RGB32);
            QPainter painter(&image);
            paintVerticalTape(painter, image.rect(), value, 2, 11, 1, true, style);
            paintCompassTape(painter, image.rect(), value, style);
        }
    }

    /// Roll, heading and pitch, each in its third of the band above the compass.
    void horizonWritesItsNumbers()
    {
        constexpr int kTape = 52, kCompass = 24, kBand = 20, kThird = 69;
        Horizon horizon;
        horizon.resize(2 * kTape + 3 * kThird, 320);
        const auto numbers = [&](const HorizonValues &values) {
            horizon.showValues(values);
            return horizon.grab(QRect(kTape, horizon.height() - kCompass - kBand, 3 * kThird, kBand)).toImage();
        };
        const HorizonValues values{.roll = 0, .pitch = -60, .heading = 10}; // nothing but ground behind the numbers
        const QImage before = numbers(values);
        HorizonValues changed[] = {values, values, values};
        changed[0].roll = 7;
        changed[1].heading = 200;
        changed[2].pitch = -67;
        for (int i = 0; i < 3; ++i) {
            const QImage after = numbers(changed[i]);
            for (int third = 0; third < 3; ++third) {
                const QRect place(third * kThird, 0, kThird, kBand);
                QCOMPARE(after.copy(place) != before.copy(place), i == third);
            }
        }
    }

    void stripNeverWrapsOrOverlaps()
    {
        open({1280, 800});
        auto *strip = m_window->findChild<StatusStrip *>();
        for (const char *state : {"waiting", "plain", "sealed", "attack"}) {
            show(QString::fromLatin1(state));
            for (int width = 2560; width >= 760; width -= 40) {
                strip->resize(width, strip->height());
                int right = 0;
                auto items = strip->findChildren<StripItem *>();
                std::ranges::sort(items, {}, [](const StripItem *item) { return item->x(); });
                for (const StripItem *item : items) {
                    if (item->isHidden())
                        continue;
                    const QByteArray what =
                        QStringLiteral("%1 at %2, %3").arg(item->objectName()).arg(width).arg(QLatin1String(state)).toUtf8();
                    QVERIFY2(item->x() >= right, what.constData());
                    right = item->x() + item->width();
                    QVERIFY2(right <= width, what.constData());
                }
            }
        }
    }

    void changingNumbersMoveNothing()
    {
        open({1280, 800});
        m_station->show(sealedSnapshot(1));
        QCoreApplication::processEvents();
        const auto places = [this] {
            QHash<QString, QRect> out;
            for (const QWidget *widget : m_window->findChildren<QWidget *>())
                if (widget->isVisible() && !widget->objectName().isEmpty()
                    && !widget->objectName().startsWith(QLatin1String("qt_")))
                    out.insert(widget->objectName(), QRect(widget->mapTo(m_window.get(), QPoint()), widget->size()));
            return out;
        };
        const auto before = places();
        engine::Snapshot snapshot = sealedSnapshot(2);
        auto &state = snapshot.vehicles.front().state;
        state.altitudeRelative = -118.8;
        state.groundSpeed = 48.8;
        state.climb = -11.1;
        state.heading = 8;
        state.distanceHome = 8888;
        state.satellites = 9;
        state.batteryVoltage = 9.1;
        state.batteryPercent = 100;
        state.latency = 0.888;
        snapshot.sessions.front().lossPercent = 0;
        snapshot.sessions.front().stats.rx.good = 8'888'888;
        snapshot.sessions.front().stats.peerRx.lost = 888;
        snapshot.links.front().rxBytesPerSecond = 888'000;
        snapshot.recording.bytes = 888'000'000;
        m_station->show(snapshot);
        QCoreApplication::processEvents();
        const auto after = places();
        for (auto at = before.begin(); at != before.end(); ++at)
            QVERIFY2(after.value(at.key()) == at.value(), qPrintable(at.key()));
    }

    void longResultsMoveNothing_data()
    {
        QTest::addColumn<QSize>("size");
        for (const QSize size : {QSize(1024, 700), QSize(1280, 800), QSize(1366, 768)})
            QTest::addRow("%dx%d", size.width(), size.height()) << size;
    }

    void longResultsMoveNothing()
    {
        QFETCH(QSize, size);
        open(size, "fly");
        m_station->show(sealedSnapshot(1));
        QCoreApplication::processEvents();
        const auto places = [this] {
            std::vector<std::pair<QString, QRect>> out;
            for (const HoldButton *button : m_window->findChildren<HoldButton *>())
                out.emplace_back(button->objectName(), QRect(button->mapTo(m_window.get(), QPoint()), button->size()));
            return out;
        };
        const auto before = places();
        QCOMPARE(before.size(), std::size_t(8));
        auto *commands = m_window->findChild<VehicleCommands *>();
        commands->send(1, vehicle::TakeOff{10});
        const QString reason = QStringLiteral(
            "failed: PreArm: Compass not healthy; PreArm: GPS 1: Bad fix; PreArm: Battery 1 "
            "below minimum arming voltage; PreArm: RC not calibrated; PreArm: Logging failed");
        m_station->notify(
            vehicle::CommandResult{vehicle::RequestId{1}, 1, vehicle::CommandOutcome::Refused, 4, reason.toStdString()});
        QCoreApplication::processEvents();
        auto *result = m_window->findChild<QLabel *>(QStringLiteral("commandResult"));
        QVERIFY(result->text().contains(reason));
        QVERIFY(result->toolTip().contains(QStringLiteral("Logging failed")));
        QVERIFY(places() == before);
        for (const auto &[name, place] : before)
            QVERIFY2(!m_window->findChild<HoldButton *>(name)->visibleRegion().isEmpty(), qPrintable(name));
    }

    /// The bar of one row leaves the result little width, but its whole height.
    void refusalIsReadable()
    {
        open(QSize(1366, 768), "fly");
        m_station->show(sealedSnapshot(1));
        m_window->findChild<VehicleCommands *>()->send(1, vehicle::TakeOff{10});
        m_station->notify(vehicle::CommandResult{vehicle::RequestId{1}, 1, vehicle::CommandOutcome::Refused, 4,
                                                 "PreArm: Battery 1 below minimum arming voltage"});
        QCoreApplication::processEvents();
        const auto *result = m_window->findChild<ResultLabel *>(QStringLiteral("commandResult"));
        const QStringList lines = result->shownLines();
        QVERIFY2(lines.join(QString()) == result->text(), qPrintable(lines.join(QLatin1Char('\n'))));
        QVERIFY(lines.size() > ResultLabel::kLines);
        QVERIFY(lines.size() * result->fontMetrics().lineSpacing() <= result->height());

        m_station->requests.clear();
        m_window->findChild<VehicleCommands *>()->send(1, vehicle::TakeOff{15});
        m_station->notify(vehicle::CommandResult{vehicle::RequestId{1}, 1, vehicle::CommandOutcome::Refused, 0,
                                                 vehicle::reasons::kNothingSent(vehicle::reasons::kTakeOffNeedsArmed())});
        QCoreApplication::processEvents();
        QVERIFY2(result->shownLines().join(QString()) == result->text(),
                 qPrintable(result->shownLines().join(QLatin1Char('\n'))));
    }

private:
    static bool needsItsRoom(const QWidget *widget)
    {
        const auto *label = qobject_cast<const QLabel *>(widget);
        if (label)
            return !label->text().isEmpty() && label->objectName() != QLatin1String("trafficLinks")
                && label->sizePolicy().horizontalPolicy() != QSizePolicy::Ignored;
        const auto *tool = qobject_cast<const QToolButton *>(widget);
        return (tool && !tool->text().isEmpty() && tool->toolButtonStyle() != Qt::ToolButtonIconOnly)
            || qobject_cast<const QPushButton *>(widget) || qobject_cast<const QRadioButton *>(widget)
            || qobject_cast<const QCheckBox *>(widget);
    }

    static bool overlaps(const QWidget *widget)
    {
        const auto siblings = widget->parentWidget()->findChildren<QWidget *>(QString(), Qt::FindDirectChildrenOnly);
        return std::ranges::any_of(siblings, [&](const QWidget *other) {
            return other != widget && other->isVisible() && needsItsRoom(other)
                && other->geometry().intersects(widget->geometry());
        });
    }

    void open(const QSize &size, const char *workspace = "lab", Theme theme = Theme::Light)
    {
        m_window.reset();
        m_folder = std::make_unique<QTemporaryDir>();
        m_store = std::make_unique<QSettings>(m_folder->filePath(QStringLiteral("s.ini")), QSettings::IniFormat);
        Settings settings;
        settings.theme = theme;
        storeSettings(*m_store, settings);
        m_station = std::make_unique<FakeStation>();
        ProgramFacts facts;
        facts.demoAvailable = true;
        m_window = std::make_unique<MainWindow>(*m_station, *m_store, facts);
        m_window->resize(size);
        m_window->show();
        m_window->findChild<QAction *>(QLatin1String("workspace_") + QLatin1String(workspace))->trigger();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), test::kDeadlineMs));
    }

    void show(const QString &state)
    {
        if (state == QLatin1String("waiting")) {
            m_station->show(waitingSnapshot());
        } else if (state == QLatin1String("plain")) {
            engine::Snapshot snapshot = plainSnapshot(1);
            snapshot.samples = samplesOf(0, 0, 20, crypto::SuiteId::None, 0); // without one, the charts have no place
            m_station->show(snapshot);
        } else {
            engine::Snapshot snapshot = sealedSnapshot(1);
            snapshot.samples = samplesOf(0, 0, 20, crypto::SuiteId::ChaCha20Poly1305, 0);
            if (state == QLatin1String("several")) {
                snapshot.vehicles.push_back(snapshot.vehicles.front());
                snapshot.vehicles.front().state.systemId = 255;
            }
            if (state == QLatin1String("attack")) {
                snapshot.security = engine::Security::UnderAttack;
                auto &session = snapshot.sessions.front();
                session.stats.rx.forged = session.forgedLastMinute = 12'345;
                session.stats.rx.replayed = session.replayedLastMinute = 678;
            }
            m_station->show(snapshot);
        }
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<QSettings> m_store;
    std::unique_ptr<FakeStation> m_station;
    std::unique_ptr<MainWindow> m_window;
};

SKYSEAL_TEST_WIDGETS(LayoutTest)
#include "layout_test.moc"
