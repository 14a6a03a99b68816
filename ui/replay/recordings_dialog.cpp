#include "ui/replay/recordings_dialog.h"

#include "ui/ask_file.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/form_pieces.h"
#include "ui/theme/grid.h"

#include <QtCore/QSortFilterProxyModel>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QStyledItemDelegate>
#include <QtWidgets/QTreeView>
#include <QtWidgets/QVBoxLayout>

#include <algorithm>

namespace skyseal::ui {

namespace {

/// Names of recordings differ at their ends as much as at their beginnings.
class NameDelegate : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        option->textElideMode = Qt::ElideMiddle;
    }
};

} // namespace

RecordingsDialog::RecordingsDialog(StationInterface &station, const QString &folder, QWidget *parent)
    : QDialog(parent), m_station(station), m_folder(folder), m_sorted(new QSortFilterProxyModel(this)),
      m_view(named(new QTreeView(this), "recordingView", tr("Recordings"))), m_state(new QLabel(this)),
      m_replay(named(new QPushButton(tr("&Replay"), this), "recordingReplay", tr("Replay the selected recording")))
{
    setObjectName(QStringLiteral("recordingsDialog"));
    setWindowTitle(tr("Replay a log"));
    m_sorted->setSourceModel(&m_model);
    m_sorted->setSortRole(RecordingModel::kSortRole);
    m_sorted->setDynamicSortFilter(false); // rows do not move under the pointer while the recordings are read
    m_view->setModel(m_sorted);
    m_view->setRootIsDecorated(false);
    m_view->setUniformRowHeights(true);
    m_view->setAllColumnsShowFocus(true);
    m_view->setSortingEnabled(true);
    m_view->sortByColumn(RecordingModel::Date, Qt::DescendingOrder);
    const QFontMetrics metrics(font());
    QHeaderView *header = m_view->header();
    const auto widen = [&](RecordingModel::Column column, const QString &sample) {
        header->resizeSection(column, metrics.horizontalAdvance(sample) + 4 * kGrid);
    };
    widen(RecordingModel::Date, QStringLiteral("8888-88-88 88:88"));
    widen(RecordingModel::Vehicle, QStringLiteral("quadrotor 1, rover 2"));
    widen(RecordingModel::Length, QStringLiteral("88:88:88"));
    widen(RecordingModel::Ciphers, QStringLiteral("ChaCha20-Poly1305, AES-256-GCM"));
    widen(RecordingModel::Size, QStringLiteral("888.8 MB"));
    widen(RecordingModel::File, QStringLiteral("8888-88-88T88-88-88Z.tlog"));
    m_view->setItemDelegateForColumn(RecordingModel::File, new NameDelegate(m_view));
    m_state->setObjectName(QStringLiteral("recordingState"));
    m_state->setTextFormat(Qt::PlainText);
    m_state->setWordWrap(true);
    auto *other = named(new QPushButton(tr("&Other file…"), this), "recordingOther", tr("Replay another file"));
    auto *close = named(new QPushButton(tr("Close"), this), "recordingClose", tr("Close"));
    m_replay->setDefault(true);

    auto *buttons = new QHBoxLayout;
    buttons->addWidget(other);
    buttons->addStretch(1);
    buttons->addWidget(m_replay);
    buttons->addWidget(close);
    auto *column = new QVBoxLayout(this);
    column->setSpacing(kGrid);
    column->addWidget(m_view, 1);
    column->addWidget(m_state);
    column->addLayout(buttons);
    const int columns = header->length() + m_view->verticalScrollBar()->sizeHint().width() + 6 * kGrid;
    resize(std::max(columns, 122 * kGrid), 50 * kGrid);

    connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this, &RecordingsDialog::showState);
    connect(m_view, &QTreeView::doubleClicked, this, &RecordingsDialog::replaySelected); // Enter is the default button's
    connect(m_replay, &QPushButton::clicked, this, &RecordingsDialog::replaySelected);
    connect(other, &QPushButton::clicked, this, &RecordingsDialog::chooseOther);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    connect(&m_station, &StationInterface::recordingsListed, this, [this](const std::vector<engine::RecordingInfo> &all) {
        m_listed = true;
        m_model.setRecordings(all);
        if (m_sorted->rowCount() > 0)
            m_view->setCurrentIndex(m_sorted->index(0, 0));
        showState();
    });
    connect(&m_station, &StationInterface::recordingRead, this, [this](const engine::RecordingInfo &one) {
        m_model.update(one);
        showState();
    });
    showState();
    m_station.listRecordings(m_folder.toStdString());
}

RecordingsDialog::~RecordingsDialog()
{
    m_station.stopListing();
}

void RecordingsDialog::showState()
{
    const int all = m_model.rowCount(), read = m_model.readCount();
    m_state->setText(!m_listed ? tr("Searching %1…").arg(m_folder)
                         : all == 0
                         ? tr("No recordings in %1. Enable recording in File → Settings, or choose \"Other file\" to "
                              "replay another log.")
                               .arg(m_folder)
                         : read < all ? tr("%1 of %2 read in %3").arg(read).arg(all).arg(m_folder)
                         : all == 1   ? tr("One recording in %1").arg(m_folder)
                                      : tr("%1 recordings in %2").arg(all).arg(m_folder));
    m_replay->setEnabled(m_view->selectionModel()->hasSelection());
}

void RecordingsDialog::replaySelected()
{
    const QModelIndex current = m_sorted->mapToSource(m_view->currentIndex());
    if (current.isValid())
        choose(fromStd(m_model.recording(current.row()).path));
}

void RecordingsDialog::chooseOther()
{
    askFile(*this, {.title = tr("Replay a log"), .kinds = tr("Telemetry logs (*.tlog);;All files (*)"), .start = m_folder},
            [this](const QString &file) { choose(file); });
}

void RecordingsDialog::choose(const QString &file)
{
    Q_EMIT fileChosen(file);
    accept();
}

} // namespace skyseal::ui

#include "moc_recordings_dialog.cpp"
