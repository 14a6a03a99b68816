#include "ui/overlays/overlay_dialog.h"

#include "ui/modeless.h"
#include "ui/overlays/overlay_model.h"
#include "ui/theme/form_pieces.h"
#include "ui/theme/grid.h"

#include <QtCore/QFileInfo>
#include <QtGui/QShortcut>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTreeView>
#include <QtWidgets/QVBoxLayout>

namespace skyseal::ui {

OverlayDialog::OverlayDialog(OverlayModel &model, QWidget *parent)
    : QDialog(parent), m_model(model), m_view(named(new QTreeView(this), "overlayView", tr("Overlays"))),
      m_state(named(new QLabel(this), "overlayState", tr("State"))),
      m_color(named(new QComboBox(this), "overlayColor", tr("Colour of the selected file"))),
      m_remove(named(new QPushButton(tr("&Remove"), this), "overlayRemove", tr("Remove the selected file from the map"))),
      m_again(named(new QPushButton(tr("Read a&gain"), this), "overlayAgain", tr("Read the selected file again")))
{
    setObjectName(QStringLiteral("overlayDialog"));
    setWindowTitle(tr("Overlays"));
    m_view->setModel(&m_model);
    m_view->setRootIsDecorated(false);
    m_view->setUniformRowHeights(true);
    m_view->setAllColumnsShowFocus(true);
    m_view->setTextElideMode(Qt::ElideMiddle);
    const QFontMetrics metrics(font());
    const auto widen = [&](OverlayModel::Column column, const QString &sample) {
        m_view->header()->resizeSection(column, metrics.horizontalAdvance(sample) + 6 * kGrid);
    };
    widen(OverlayModel::File, QStringLiteral("no-fly areas of the region.geojson"));
    widen(OverlayModel::Color, tr("Orange"));
    widen(OverlayModel::Shapes, QStringLiteral("888 888"));
    for (int i = 0; i < kOverlayColors; ++i)
        m_color->addItem(overlayColorText(static_cast<OverlayColor>(i)));
    m_state->setTextFormat(Qt::PlainText);
    m_state->setWordWrap(true);
    m_state->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_state->setMinimumHeight(3 * metrics.lineSpacing()); // what is below does not move
    auto *addFiles = named(new QPushButton(tr("&Add…"), this), "overlayAdd", tr("Add KML or GeoJSON files"));
    auto *close = named(new QPushButton(tr("Close"), this), "overlayClose", tr("Close"));
    auto *colorLabel = new QLabel(tr("&Colour"), this);
    colorLabel->setBuddy(m_color);
    for (QPushButton *button : {addFiles, m_remove, m_again})
        button->setAutoDefault(false);
    close->setDefault(true);

    auto *buttons = new QHBoxLayout;
    for (QWidget *part : std::initializer_list<QWidget *>{addFiles, m_remove, m_again, colorLabel, m_color})
        buttons->addWidget(part);
    buttons->addStretch(1);
    buttons->addWidget(close);
    auto *column = new QVBoxLayout(this);
    column->setSpacing(kGrid);
    column->addWidget(m_view, 1);
    column->addWidget(m_state);
    column->addLayout(buttons);
    resize(88 * kGrid, 40 * kGrid);

    connect(addFiles, &QPushButton::clicked, this, &OverlayDialog::chooseFiles);
    connect(m_remove, &QPushButton::clicked, this, &OverlayDialog::removeSelected);
    connect(new QShortcut(QKeySequence::Delete, m_view, nullptr, nullptr, Qt::WidgetShortcut), &QShortcut::activated, this,
            &OverlayDialog::removeSelected);
    connect(m_again, &QPushButton::clicked, this, [this] { m_model.readAgain(row()); });
    connect(m_color, &QComboBox::currentIndexChanged, this, [this](int color) {
        if (row() >= 0)
            m_model.setColor(row(), static_cast<OverlayColor>(color));
    });
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    // The space bar ticks the current cell: that of the file, whichever was clicked.
    connect(m_view->selectionModel(), &QItemSelectionModel::currentChanged, this, [this](const QModelIndex &current) {
        if (current.isValid() && current.column() != OverlayModel::File)
            m_view->setCurrentIndex(current.siblingAtColumn(OverlayModel::File));
        refresh();
    });
    connect(&m_model, &OverlayModel::dataChanged, this, &OverlayDialog::refresh);
    connect(&m_model, &OverlayModel::rowsInserted, this, &OverlayDialog::refresh);
    connect(&m_model, &OverlayModel::rowsRemoved, this, &OverlayDialog::refresh);
    if (m_model.rowCount() > 0)
        m_view->setCurrentIndex(m_model.index(0, 0));
    refresh();
    m_model.check();
}

int OverlayDialog::row() const
{
    return m_view->currentIndex().row();
}

void OverlayDialog::chooseFiles()
{
    if (raiseOpen<QFileDialog>(*this))
        return;
    const int selected = row();
    const QString folder = selected < 0 ? QString() : QFileInfo(m_model.files()[selected].path).path();
    auto *dialog = new QFileDialog(this, tr("Add overlays"), folder,
                                   tr("KML and GeoJSON (*.kml *.geojson *.json);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFiles);
    connect(dialog, &QFileDialog::filesSelected, this, &OverlayDialog::add);
    showModeless(*dialog);
}

void OverlayDialog::add(const QStringList &files)
{
    m_isFull = false;
    for (const QString &file : files)
        m_isFull |= !m_model.add(file);
    m_view->setCurrentIndex(m_model.index(m_model.rowCount() - 1, 0));
    refresh();
}

void OverlayDialog::removeSelected()
{
    m_isFull = false;
    if (row() >= 0)
        m_model.remove(row());
    refresh();
}

void OverlayDialog::refresh()
{
    const int selected = row();
    const bool any = selected >= 0;
    m_remove->setEnabled(any);
    m_again->setEnabled(any);
    m_color->setEnabled(any);
    if (any)
        m_color->setCurrentIndex(static_cast<int>(m_model.entries()[static_cast<std::size_t>(selected)].file.color));
    m_state->setText(
        m_isFull  ? tr("There are %1 files, and no more can be added. Remove one first.").arg(kMostOverlays)
            : any ? m_model.stateText(selected)
            : m_model.rowCount() > 0
            ? QString()
            : tr("No overlays. Add… draws the points, lines and areas of KML and GeoJSON files over the map. They are "
                 "for display only: the vehicle does not know about them."));
}

} // namespace skyseal::ui

#include "moc_overlay_dialog.cpp"
