#include "ui/status/traffic_bar.h"

#include "core/engine/station/snapshot.h"
#include "core/engine/text/state_text.h"
#include "ui/text/figures.h"
#include "ui/text/units.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtCore/QFileInfo>
#include <QtWidgets/QLabel>

namespace skyseal::ui {

TrafficBar::TrafficBar(QWidget *parent) : QStatusBar(parent)
{
    setSizeGripEnabled(false);
    m_links = new QLabel(this);
    m_links->setObjectName(QStringLiteral("trafficLinks"));
    m_links->setAccessibleName(tr("Links"));
    m_links->setContentsMargins(kGrid, 0, kGrid, 0);
    const auto figure = [&](const char *objectName, const QString &accessible, const QString &sample) {
        auto *label = new FigureLabel(this);
        label->setObjectName(QLatin1String(objectName));
        label->setAccessibleName(accessible);
        label->setSample(sample, {});
        label->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
        return label;
    };
    m_rx = figure("trafficRx", tr("Received"), QStringLiteral("rx 888 kB/s"));
    m_tx = figure("trafficTx", tr("Sent"), QStringLiteral("tx 888 kB/s"));
    m_recording = figure("trafficRecording", tr("Recording"), tr("recording %1").arg(QStringLiteral("888 MB")));
    addWidget(m_links, 1);
    addPermanentWidget(m_rx);
    addPermanentWidget(m_tx);
    addPermanentWidget(m_recording);
    setContentsMargins(0, 0, kGrid, 0);
    showViewState({});
}

void TrafficBar::showViewState(const ViewState &view)
{
    const StateColors &colors = stateColors(palette());
    QStringList parts;
    double rx = 0, tx = 0;
    bool problem = false;
    const SnapshotPtr &station = view.station();
    if (station) {
        for (const auto &link : station->links) {
            rx += link.rxBytesPerSecond;
            tx += link.txBytesPerSecond;
            problem |= !link.problem.empty();
            const QString where = fromStd(link.localAddress.empty() ? link.url : link.localAddress);
            parts << (link.problem.empty()
                          ? tr("%1 %2").arg(engine::linkPhaseText(link.phase), where)
                          : tr("%1 %2 (%3)").arg(engine::linkPhaseText(link.phase), where, reasonText(link.problem)));
        }
    }
    const QString links = parts.isEmpty() ? tr("no link") : parts.join(QStringLiteral(" · "));
    if (m_links->text() != links) {
        m_links->setText(links);
        m_links->setToolTip(parts.join(QLatin1Char('\n')));
        m_links->setMinimumWidth(1); // shortens instead of widening the window
        QPalette colored = palette();
        if (problem)
            colored.setColor(QPalette::WindowText, colors.warning);
        m_links->setPalette(colored);
    }
    m_rx->setFigure(QStringLiteral("rx ") + rateText(rx));
    m_tx->setFigure(QStringLiteral("tx ") + rateText(tx));
    const engine::RecordingSnapshot none;
    const auto &recording = station ? station->recording : none;
    if (!recording.problem.empty()) {
        m_recording->setFigure(tr("not recording"));
        m_recording->setColor(colors.alarm);
        m_recording->setToolTip(reasonText(recording.problem));
    } else {
        m_recording->setFigure(recording.active ? tr("recording %1").arg(sizeText(recording.bytes)) : tr("not recording"));
        m_recording->setColor({});
        m_recording->setToolTip(fromStd(recording.file));
    }
}

} // namespace skyseal::ui

#include "moc_traffic_bar.cpp"
