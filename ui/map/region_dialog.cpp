#include "ui/map/region_dialog.h"

#include "ui/modeless.h"
#include "ui/text/units.h"
#include "ui/theme/form_pieces.h"
#include "ui/theme/grid.h"
#include "ui/tiles/tile_template.h"

#include <QtCore/QDir>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QFormLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QProgressBar>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSpinBox>
#include <QtWidgets/QVBoxLayout>

namespace skyseal::ui {

namespace {

QString forbiddenReason(const MapSource &source)
{
    if (source.kind != MapSource::Kind::Server)
        return RegionDialog::tr("Choose a tile server as the map source first");
    const auto server = TileTemplate::parse(source.url);
    return server ? server->offlineForbiddenReason() : server.error();
}

QString bytesText(qint64 bytes)
{
    return sizeText(static_cast<std::uint64_t>(bytes));
}

} // namespace

RegionDialog::RegionDialog(TileLoader &loader, const MapSource &source, const QRectF &metres, int level, QWidget *parent)
    : QDialog(parent), m_loader(loader), m_forbidden(forbiddenReason(source)), m_metres(metres)
{
    constexpr int kLevelsBelow = 3;
    setObjectName(QStringLiteral("regionDialog"));
    setWindowTitle(tr("Fetch the area in view"));
    m_from = named(new QSpinBox(this), "regionFrom", tr("From zoom level"));
    m_to = named(new QSpinBox(this), "regionTo", tr("To zoom level"));
    for (QSpinBox *box : {m_from, m_to})
        box->setRange(0, std::min(source.deepest, TileId::kDeepest));
    m_from->setValue(std::min(level, source.deepest));
    m_to->setValue(std::min(level + kLevelsBelow, source.deepest));
    m_path = named(new QLineEdit(QDir::home().filePath(tr("area.mbtiles")), this), "regionPath", tr("File"));
    m_browse = named(new QPushButton(tr("&Browse…"), this), "regionBrowse", tr("Browse for the file"));
    m_bar = named(new QProgressBar(this), "regionBar", tr("Progress"));
    m_bar->setRange(0, 1);
    m_state = new QLabel(this);
    m_state->setObjectName(QStringLiteral("regionState"));
    m_state->setTextFormat(Qt::PlainText);
    m_state->setWordWrap(true);
    m_state->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_state->setMinimumHeight(3 * m_state->fontMetrics().lineSpacing());
    m_start = named(new QPushButton(tr("&Fetch"), this), "regionStart", tr("Fetch"));
    m_use = named(new QPushButton(tr("&Use as map source"), this), "regionUse", tr("Use the file as the map source"));
    m_use->setEnabled(false);
    m_cancel = named(new QPushButton(tr("Close"), this), "regionCancel", tr("Close"));

    auto *form = new QFormLayout;
    auto *levels = new QHBoxLayout;
    levels->addWidget(m_from);
    levels->addWidget(new QLabel(tr("to"), this));
    levels->addWidget(m_to);
    levels->addStretch(1);
    auto *label = new QLabel(tr("Zoom &levels"), this);
    label->setBuddy(m_from);
    form->addRow(label, levels);
    auto *where = new QHBoxLayout;
    where->addWidget(m_path, 1);
    where->addWidget(m_browse);
    auto *fileLabel = new QLabel(tr("F&ile"), this);
    fileLabel->setBuddy(m_path);
    form->addRow(fileLabel, where);
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(kGrid);
    buttons->addStretch(1);
    for (QPushButton *button : {m_start, m_use, m_cancel}) {
        button->setAutoDefault(false);
        buttons->addWidget(button);
    }
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(2 * kGrid, 2 * kGrid, 2 * kGrid, 2 * kGrid);
    column->setSpacing(kGrid);
    column->addLayout(form);
    column->addWidget(smallPrint(tr("Tiles are fetched two at a time. Check that the server permits it."), this));
    column->addWidget(m_bar);
    column->addWidget(m_state);
    column->addStretch(1);
    column->addLayout(buttons);
    setMinimumWidth(60 * kGrid);

    for (QSpinBox *box : {m_from, m_to})
        connect(box, &QSpinBox::valueChanged, this, &RegionDialog::refresh);
    connect(m_path, &QLineEdit::textChanged, this, &RegionDialog::refresh);
    connect(m_browse, &QPushButton::clicked, this, &RegionDialog::browse);
    connect(m_start, &QPushButton::clicked, this, &RegionDialog::start);
    connect(m_use, &QPushButton::clicked, this, [this] {
        Q_EMIT useRequested(m_file);
        accept();
    });
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        if (m_running)
            m_loader.cancelRegion();
        else
            reject();
    });
    connect(&loader, &TileLoader::regionProgressed, this, &RegionDialog::showProgress);
    connect(&loader, &TileLoader::regionEnded, this, &RegionDialog::showEnd);
    refresh();
}

void RegionDialog::done(int result)
{
    if (m_running)
        m_loader.cancelRegion();
    m_running = false;
    QDialog::done(result);
}

TileRegion RegionDialog::region() const
{
    return {m_metres, m_from->value(), m_to->value()};
}

void RegionDialog::refresh()
{
    const qint64 count = region().count();
    QString wrong = m_forbidden;
    if (wrong.isEmpty() && m_from->value() > m_to->value())
        wrong = tr("The first zoom level is greater than the last");
    else if (wrong.isEmpty() && count > kMostTiles)
        wrong = tr("%L1 tiles: at most %L2 can be fetched at a time. Zoom in, or choose fewer zoom levels")
                    .arg(count)
                    .arg(kMostTiles);
    else if (wrong.isEmpty() && m_path->text().isEmpty())
        wrong = tr("No file is chosen");
    m_start->setEnabled(wrong.isEmpty() && !m_running);
    m_start->setToolTip(wrong);
    for (QWidget *field : std::initializer_list<QWidget *>{m_from, m_to, m_path, m_browse})
        field->setEnabled(!m_running);
    m_cancel->setText(m_running ? tr("Cancel") : tr("Close"));
    m_cancel->setAccessibleName(m_cancel->text());
    if (!m_running)
        m_state->setText(wrong.isEmpty() ? tr("%L1 tiles").arg(count) : wrong);
}

void RegionDialog::browse()
{
    auto *dialog = new QFileDialog(this, tr("Fetch the area into"), m_path->text(), tr("MBTiles (*.mbtiles)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("mbtiles"));
    connect(dialog, &QFileDialog::fileSelected, m_path, &QLineEdit::setText);
    showModeless(*dialog);
}

void RegionDialog::start()
{
    m_running = true;
    m_file.clear();
    m_use->setEnabled(false);
    refresh();
    showProgress({0, region().count(), 0, 0});
    m_loader.fetchRegion(region(), m_path->text());
}

void RegionDialog::showProgress(const RegionProgress &progress)
{
    if (!m_running)
        return;
    m_bar->setRange(0, static_cast<int>(progress.total));
    m_bar->setValue(static_cast<int>(progress.done + progress.failed));
    QString text = tr("%L1 of %L2 tiles, %3").arg(progress.done).arg(progress.total).arg(bytesText(progress.bytes));
    if (progress.done > 0)
        text += tr(" of about %1").arg(bytesText(progress.bytes / progress.done * progress.total));
    if (progress.failed > 0)
        text += tr("; %L1 failed").arg(progress.failed);
    m_state->setText(text);
}

void RegionDialog::showEnd(const RegionEnd &end)
{
    if (!m_running)
        return;
    m_running = false;
    refresh();
    m_file = end.file;
    m_use->setEnabled(!end.file.isEmpty());
    if (!end.problem.isEmpty())
        m_state->setText(tr("Not fetched: %1").arg(end.problem));
    else if (end.file.isEmpty())
        m_state->setText(tr("Cancelled; no file was written"));
    else if (end.progress.failed > 0)
        m_state->setText(
            tr("%1: %2, without %L3 tiles that failed").arg(end.file, bytesText(end.progress.bytes)).arg(end.progress.failed));
    else
        m_state->setText(tr("%1: %2").arg(end.file, bytesText(end.progress.bytes)));
}

} // namespace skyseal::ui

#include "moc_region_dialog.cpp"
