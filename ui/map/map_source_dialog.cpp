#include "ui/map/map_source_dialog.h"

#include "ui/modeless.h"
#include "ui/theme/form_pieces.h"
#include "ui/theme/grid.h"
#include "ui/tiles/tile_file.h"
#include "ui/tiles/tile_template.h"

#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QFormLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QRadioButton>
#include <QtWidgets/QSpinBox>
#include <QtWidgets/QVBoxLayout>

namespace skyseal::ui {

MapSourceDialog::MapSourceDialog(const MapSource &source, QWidget *parent) : QDialog(parent), m_start(source)
{
    setObjectName(QStringLiteral("mapSourceDialog"));
    setWindowTitle(tr("Map source"));
    m_none = named(new QRadioButton(tr("&No imagery: lines of latitude and longitude"), this), "mapSourceNone",
                   tr("No imagery"));
    m_server = named(new QRadioButton(tr("A tile &server"), this), "mapSourceServer", tr("A tile server"));
    m_file = named(new QRadioButton(tr("A &file on this computer (MBTiles or GeoPackage)"), this), "mapSourceFile",
                   tr("A file of map tiles"));
    m_serverForm = makeServer();
    m_fileForm = makeFile();
    m_state = new QLabel(this);
    m_state->setObjectName(QStringLiteral("mapSourceState"));
    m_state->setTextFormat(Qt::PlainText);
    m_state->setWordWrap(true);
    m_state->setMinimumHeight(2 * m_state->fontMetrics().lineSpacing());
    m_state->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    m_ok = buttons->button(QDialogButtonBox::Ok);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(2 * kGrid, 2 * kGrid, 2 * kGrid, 2 * kGrid);
    column->setSpacing(kGrid);
    for (QWidget *part : std::initializer_list<QWidget *>{m_none, m_server, m_serverForm, m_file, m_fileForm, m_state})
        column->addWidget(part);
    column->addStretch(1);
    column->addWidget(buttons);

    QRadioButton *chosen = source.kind == MapSource::Kind::Server ? m_server
        : source.kind == MapSource::Kind::File                    ? m_file
                                                                  : m_none;
    chosen->setChecked(true);
    for (const QRadioButton *button : {m_none, m_server, m_file})
        connect(button, &QRadioButton::toggled, this, &MapSourceDialog::refresh);
    for (const QLineEdit *field : {m_url, m_attribution, m_path})
        connect(field, &QLineEdit::textChanged, this, &MapSourceDialog::refresh);
    refresh();
    constexpr int kWidth = 72 * kGrid;
    setMinimumSize(kWidth, column->totalHeightForWidth(kWidth));
}

QWidget *MapSourceDialog::makeServer()
{
    auto *box = new QWidget(this);
    auto *form = new QFormLayout(box);
    form->setContentsMargins(3 * kGrid, 0, 0, kGrid);
    m_url = named(new QLineEdit(m_start.url, box), "mapSourceUrl", tr("Address of the tiles"));
    m_url->setPlaceholderText(QStringLiteral("https://tile.example.org/{z}/{x}/{y}.png"));
    m_attribution = named(new QLineEdit(m_start.attribution, box), "mapSourceAttribution", tr("Attribution"));
    m_attribution->setPlaceholderText(tr("© map data; required by most servers"));
    m_deepest = named(new QSpinBox(box), "mapSourceDeepest", tr("Maximum zoom level"));
    m_deepest->setRange(1, TileId::kDeepest);
    m_deepest->setValue(m_start.deepest);
    form->addRow(tr("&Address"), m_url);
    form->addRow(tr("A&ttribution"), m_attribution);
    form->addRow(tr("Ma&ximum zoom level"), m_deepest);
    form->addRow(smallPrint(tr("The server learns which areas you view and when, and thus where you fly, and the address "
                               "of this computer. With http://, anyone on the path learns it too. Nothing is requested "
                               "until you press OK; received tiles are kept on this computer."),
                            box));
    return box;
}

QWidget *MapSourceDialog::makeFile()
{
    auto *box = new QWidget(this);
    auto *row = new QHBoxLayout(box);
    row->setContentsMargins(3 * kGrid, 0, 0, kGrid);
    m_path = named(new QLineEdit(m_start.file, box), "mapSourcePath", tr("File of map tiles"));
    auto *browseButton = named(new QPushButton(tr("&Browse…"), box), "mapSourceBrowse", tr("Browse for a file of map tiles"));
    browseButton->setAutoDefault(false);
    connect(browseButton, &QPushButton::clicked, this, &MapSourceDialog::browse);
    row->addWidget(m_path, 1);
    row->addWidget(browseButton);
    return box;
}

void MapSourceDialog::browse()
{
    auto *dialog = new QFileDialog(this, tr("File of map tiles"), m_path->text(),
                                   tr("Map tiles (*.mbtiles *.gpkg);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, m_path, &QLineEdit::setText);
    showModeless(*dialog);
}

QString MapSourceDialog::problem() const
{
    if (m_server->isChecked()) {
        const auto server = TileTemplate::parse(m_url->text());
        return server ? QString() : server.error();
    }
    if (m_file->isChecked()) {
        if (m_path->text().isEmpty())
            return tr("No file is chosen");
        const auto file = TileFile::open(m_path->text());
        return file ? QString() : file.error();
    }
    return {};
}

void MapSourceDialog::refresh()
{
    m_serverForm->setEnabled(m_server->isChecked());
    m_fileForm->setEnabled(m_file->isChecked());
    const QString wrong = problem();
    m_ok->setEnabled(wrong.isEmpty());
    m_ok->setToolTip(wrong);
    QString state = wrong;
    if (wrong.isEmpty() && m_server->isChecked())
        state = tr("Tiles will be requested from %1").arg(TileTemplate::parse(m_url->text())->host());
    m_state->setText(state);
}

MapSource MapSourceDialog::source() const
{
    MapSource out = m_start;
    out.kind = m_server->isChecked() ? MapSource::Kind::Server
        : m_file->isChecked()        ? MapSource::Kind::File
                                     : MapSource::Kind::None;
    out.url = m_url->text().trimmed();
    out.attribution = m_attribution->text().trimmed();
    out.deepest = m_deepest->value();
    out.file = m_path->text();
    return out;
}

} // namespace skyseal::ui

#include "moc_map_source_dialog.cpp"
