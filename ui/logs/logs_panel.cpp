#include "ui/logs/logs_panel.h"

#include "core/engine/station/snapshot.h"
#include "ui/control_action.h"
#include "ui/text/figures.h"
#include "ui/text/units.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtCore/QUrl>
#include <QtGui/QDesktopServices>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>

namespace skyseal::ui {

LogsPanel::LogsPanel(StationInterface &station, const QString &folder, QWidget *parent)
    : DockPanel(parent), m_station(station), m_folder(folder)
{
    m_record = new QCheckBox(tr("Record received and sent frames"), this);
    m_record->setObjectName(QStringLiteral("logRecord"));
    m_record->setAccessibleName(m_record->text());
    auto *replay = new QPushButton(tr("Replay a log…"), this);
    replay->setObjectName(QStringLiteral("logReplay"));
    replay->setAccessibleName(tr("Replay a log"));
    auto *open = new QPushButton(tr("Open the folder"), this);
    open->setObjectName(QStringLiteral("logFolder"));
    open->setAccessibleName(open->text());
    open->setEnabled(!folder.isEmpty());
    m_file = new QLabel(this);
    m_file->setAccessibleName(tr("File being recorded"));
    m_file->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_file->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_problem = new QLabel(this);
    for (QLabel *label : {m_file, m_problem}) // with the names of files
        label->setTextFormat(Qt::PlainText);
    m_problem->setWordWrap(true);

    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
    grid->setHorizontalSpacing(2 * kGrid);
    grid->setVerticalSpacing(kHalfGrid);
    grid->setColumnStretch(2, 1);
    grid->addWidget(m_record, 0, 0, 1, 3);
    int row = 1;
    const auto line = [&](const QString &name, QWidget *value, int columns) {
        auto *label = new QLabel(name, this);
        label->setForegroundRole(QPalette::PlaceholderText);
        grid->addWidget(label, row, 0);
        grid->addWidget(value, row++, 1, 1, columns);
    };
    line(tr("file"), m_file, 2);
    const auto figure = [&](const QString &name) {
        auto *label = new FigureLabel(this);
        label->setAccessibleName(name);
        label->setSample(QStringLiteral("888 888 888"), {});
        line(name, label, 1);
        return label;
    };
    m_size = figure(tr("size"));
    m_frames = figure(tr("frames"));
    m_dropped = figure(tr("dropped"));
    grid->addWidget(m_problem, row++, 0, 1, 3);
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(kGrid);
    buttons->addWidget(replay);
    buttons->addWidget(open);
    buttons->addStretch(1);
    grid->addLayout(buttons, row++, 0, 1, 3);
    grid->setRowStretch(row, 1);

    connect(m_record, &QCheckBox::clicked, this, [this](bool on) { m_station.setRecording(on); });
    connect(open, &QPushButton::clicked, this, [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(m_folder)); });
    connect(replay, &QPushButton::clicked, this, &LogsPanel::replayRequested);
    addActions({pressAction(*m_record, Qt::CTRL | Qt::Key_T), pressAction(*open, Qt::CTRL | Qt::SHIFT | Qt::Key_F5)});
    showViewState({});
}

void LogsPanel::showViewState(const ViewState &view)
{
    static const engine::RecordingSnapshot kNone;
    const auto &recording = view.station() ? view.station()->recording : kNone;
    if (!m_record->isDown())
        m_record->setChecked(recording.active);
    const QString file = recording.file.empty() ? (m_folder.isEmpty() ? dash() : m_folder) : fromStd(recording.file);
    if (m_file->text() != file) {
        m_file->setText(file);
        m_file->setToolTip(file);
    }
    m_size->setFigure(recording.active ? sizeText(recording.bytes) : dash());
    m_frames->setFigure(recording.active ? grouped(recording.frames) : dash());
    m_dropped->setFigure(recording.active ? grouped(recording.dropped) : dash());
    m_dropped->setColor(recording.dropped > 0 ? stateColors(palette()).warning : QColor());
    const QString problem = reasonText(recording.problem);
    if (m_problem->text() != problem)
        m_problem->setText(problem);
}

} // namespace skyseal::ui

#include "moc_logs_panel.cpp"
