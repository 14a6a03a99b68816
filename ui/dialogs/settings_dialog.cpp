#include "ui/dialogs/settings_dialog.h"

#include "core/base/research.h"
#include "core/engine/text/qt_text.h"
#include "core/link/link_url.h"
#include "ui/alerts/speech.h"
#include "ui/ask_file.h"
#include "ui/form_scroll.h"
#include "ui/language.h"
#include "ui/theme/form_pieces.h"
#include "ui/theme/grid.h"
#include "ui/theme/suite_style.h"

#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QFormLayout>
#include <QtWidgets/QGroupBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSpinBox>
#include <QtWidgets/QVBoxLayout>

#include <algorithm>
#include <map>
#include <vector>

namespace skyseal::ui {

namespace {

QString researchSuites()
{
    QStringList names;
    for (const crypto::SuiteInfo &suite : crypto::suites()) {
        if (suite.research)
            names << QString::fromUtf8(suite.displayName.data(), static_cast<qsizetype>(suite.displayName.size()));
    }
    return names.join(QStringLiteral(", "));
}

} // namespace

SettingsDialog::SettingsDialog(const Settings &settings, QWidget *parent) : QDialog(parent), m_start(settings)
{
    setObjectName(QStringLiteral("settingsDialog"));
    setWindowTitle(tr("Settings"));
    auto *form = new QWidget(this);
    auto *inner = new QVBoxLayout(form);
    inner->setContentsMargins(0, 0, 0, 0);
    inner->setSpacing(2 * kGrid);
    auto *beside = new QHBoxLayout; // touch-sized, all of them below each other would be higher than many screens
    beside->setSpacing(2 * kGrid);
    beside->addWidget(makeView(), 1);
    beside->addWidget(makeStation(), 1);
    inner->addLayout(beside);
    inner->addWidget(makeSecurity());
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(2 * kGrid, 2 * kGrid, 2 * kGrid, 2 * kGrid);
    column->setSpacing(2 * kGrid);
    constexpr int kWidth = 96 * kGrid; // at which the texts below the fields wrap to a few lines
    column->addWidget(new FormScroll(form, kWidth), 1);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    m_ok = buttons->button(QDialogButtonBox::Ok);
    connect(m_link, &QLineEdit::textChanged, this, &SettingsDialog::check);
    connect(m_systemId, &QSpinBox::valueChanged, this, &SettingsDialog::check);
    check();
    fitToScreen(*this);
}

void SettingsDialog::setVehicles(const std::bitset<256> &systems)
{
    m_vehicles = systems;
    check();
}

/// An invalid link URL is not accepted, nor the system id of a vehicle as a new one. Where a vehicle has the present one, the
/// other settings can be changed all the same.
void SettingsDialog::check()
{
    const auto parsed = link::LinkUrl::parse(m_link->text().toStdString());
    m_link->setToolTip(parsed ? QString() : engine::reasonText(parsed.error().message));
    const int id = m_systemId->value();
    const bool taken = m_vehicles.test(static_cast<std::size_t>(id));
    m_idTaken->setText(taken ? tr("System ID %1 is a vehicle's: choose another one.").arg(id) : QString());
    m_idTaken->setVisible(taken);
    m_ok->setEnabled(parsed.has_value() && (!taken || id == m_start.systemId));
}

QWidget *SettingsDialog::makeView()
{
    auto *box = new QGroupBox(tr("View"), this);
    auto *form = new QFormLayout(box);
    m_language = named(new QComboBox(box), "settingLanguage", tr("Language"));
    m_language->addItem(tr("same as the desktop"), QString());
    for (const Language &each : languages())
        m_language->addItem(QLatin1String(each.name), QString::fromLatin1(each.code));
    m_language->setCurrentIndex(std::max(0, m_language->findData(m_start.language)));
    m_theme = named(new QComboBox(box), "settingTheme", tr("Colours"));
    m_theme->addItem(tr("desktop default"), static_cast<int>(Theme::Desktop));
    m_theme->addItem(tr("light"), static_cast<int>(Theme::Light));
    m_theme->addItem(tr("dark"), static_cast<int>(Theme::Dark));
    m_theme->addItem(tr("high contrast"), static_cast<int>(Theme::HighContrast));
    m_theme->setCurrentIndex(m_theme->findData(static_cast<int>(m_start.theme)));
    m_units = named(new QComboBox(box), "settingUnits", tr("Units"));
    m_units->addItem(tr("metric (m, m/s)"), static_cast<int>(UnitSystem::Metric));
    m_units->addItem(tr("imperial (ft, mph)"), static_cast<int>(UnitSystem::Imperial));
    m_units->addItem(tr("aviation (ft, kt, NM)"), static_cast<int>(UnitSystem::Aviation));
    m_units->setCurrentIndex(m_units->findData(static_cast<int>(m_start.units)));
    m_coordinates = named(new QComboBox(box), "settingCoordinates", tr("Coordinates"));
    m_coordinates->addItem(tr("decimal degrees"), static_cast<int>(CoordinateFormat::Decimal));
    m_coordinates->addItem(tr("degrees, minutes, seconds"), static_cast<int>(CoordinateFormat::DegreesMinutesSeconds));
    m_coordinates->addItem(tr("UTM (metres in a zone)"), static_cast<int>(CoordinateFormat::Utm));
    m_coordinates->addItem(tr("MGRS (grid reference)"), static_cast<int>(CoordinateFormat::Mgrs));
    m_coordinates->setCurrentIndex(m_coordinates->findData(static_cast<int>(m_start.coordinates)));
    form->addRow(tr("Lan&guage"), m_language);
    form->addRow(QString(), smallPrint(tr("The language takes effect at the next start."), box));
    form->addRow(tr("&Colours"), m_theme);
    form->addRow(tr("&Units"), m_units);
    form->addRow(tr("Coordi&nates"), m_coordinates);
    m_touch = named(new QCheckBox(tr("&Touch-sized controls"), box), "settingTouch", tr("Touch-sized controls"));
    m_touch->setToolTip(tr("Buttons, menus and lists are large enough for fingers"));
    m_touch->setChecked(m_start.touchSized);
    form->addRow(QString(), m_touch);
    m_speak = named(new QCheckBox(tr("Speak &alerts"), box), "settingSpeak", tr("Speak alerts"));
    m_speak->setChecked(m_start.speakAlerts);
    m_speak->setEnabled(isDesktopVoiceBuilt());
    form->addRow(QString(), m_speak);
    if (!isDesktopVoiceBuilt())
        form->addRow(QString(), smallPrint(tr("This build of Skyseal has no speech: it lacks speech-dispatcher."), box));
    return box;
}

QWidget *SettingsDialog::makeStation()
{
    auto *box = new QGroupBox(tr("Station"), this);
    auto *form = new QFormLayout(box);
    m_systemId = named(new QSpinBox(box), "settingSystemId", tr("MAVLink system ID"));
    m_systemId->setRange(1, 255);
    m_systemId->setValue(m_start.systemId);
    m_componentId = named(new QSpinBox(box), "settingComponentId", tr("MAVLink component ID"));
    m_componentId->setRange(1, 255);
    m_componentId->setValue(m_start.componentId);
    m_link = named(new QLineEdit(m_start.defaultLink, box), "settingLink", tr("Link to open at start"));
    m_record = named(new QCheckBox(tr("&Record received and sent frames (.tlog)"), box), "settingRecord", tr("Record"));
    m_record->setChecked(m_start.record);
    m_folder = named(new QLineEdit(m_start.recordFolder, box), "settingFolder", tr("Folder of the recordings"));
    m_folder->setPlaceholderText(tr("the default folder"));
    auto *browse = new QPushButton(tr("Browse…"), box);
    browse->setAccessibleName(tr("Browse for the folder of the recordings"));
    connect(browse, &QPushButton::clicked, this, [this] {
        askFile(*this, {.title = tr("Folder of the recordings"), .start = m_folder->text(), .use = FileQuestion::Use::Folder},
                [this](const QString &folder) { m_folder->setText(folder); });
    });
    auto *where = new QHBoxLayout;
    where->addWidget(m_folder, 1);
    where->addWidget(browse);
    form->addRow(tr("MAVLink &system"), m_systemId);
    m_idTaken = named(new QLabel(box), "settingIdTaken", tr("Why the system ID cannot be chosen"));
    m_idTaken->setWordWrap(true);
    form->addRow(QString(), m_idTaken);
    form->addRow(tr("MAVLink c&omponent"), m_componentId);
    form->addRow(tr("&Link at start"), m_link);
    form->addRow(QString(), m_record);
    auto *folderLabel = new QLabel(tr("&Folder"), box);
    folderLabel->setBuddy(m_folder); // a form finds no buddy in a row of widgets
    form->addRow(folderLabel, where);
    form->addRow(QString(), smallPrint(tr("IDs, link and folder take effect at the next start."), box));
    return box;
}

/// One entry for each level of strength, the weakest first; its first suite stands for the level.
void SettingsDialog::offerWeakestSuites()
{
    std::map<crypto::SuiteStrength, std::vector<crypto::SuiteId>> levels;
    for (const crypto::SuiteId suite : crypto::sealedSuites())
        levels[crypto::suiteInfo(suite).strength].push_back(suite);
    for (const auto &[strength, suites] : levels) {
        QStringList names;
        for (const crypto::SuiteId suite : suites)
            names << suiteName(suite);
        const QString list = names.join(QStringLiteral(", "));
        const bool weakest = strength == levels.begin()->first;
        const bool strongest = strength == levels.rbegin()->first;
        m_weakest->addItem(weakest         ? tr("Any sealed suite")
                               : strongest ? tr("Only %1").arg(list)
                                           : tr("%1 or stronger").arg(list),
                           static_cast<int>(suites.front()));
        if (strength == crypto::suiteInfo(m_start.weakestSuite).strength)
            m_weakest->setCurrentIndex(m_weakest->count() - 1);
    }
}

QWidget *SettingsDialog::makeSecurity()
{
    auto *box = new QGroupBox(tr("Security"), this);
    auto *column = new QVBoxLayout(box);
    m_required = named(new QCheckBox(tr("Show sealed vehicles &only"), box), "settingRequired",
                       tr("Show sealed vehicles only"));
    m_required->setChecked(m_start.requireSealed || !kResearch);
    m_required->setEnabled(kResearch);
    m_research = named(new QCheckBox(tr("Allow &insecure research suites (%1)").arg(researchSuites()), box), "settingResearch",
                       tr("Allow insecure research suites"));
    m_research->setChecked(m_start.allowResearch);
    column->addWidget(m_required);
    column->addWidget(smallPrint(tr("Plain MAVLink is then neither shown nor answered. Takes effect at the next start."), box));
    m_weakest = named(new QComboBox(box), "settingWeakest", tr("Weakest suite"));
    offerWeakestSuites();
    auto *weakest = new QHBoxLayout;
    auto *label = new QLabel(tr("&Weakest suite"), box);
    label->setBuddy(m_weakest);
    weakest->addWidget(label);
    weakest->addWidget(m_weakest, 1);
    column->addLayout(weakest);
    column->addWidget(m_research);
    auto *broken = smallPrint(
        tr("Research suites (%1) are broken: anyone who records the link may be able to read it. They are provided "
           "for comparison, are never chosen automatically, and work only when the vehicle's agent allows them as well. "
           "While one is in use, the link is not confidential.")
            .arg(researchSuites()),
        box);
    column->addWidget(broken);
    m_research->setVisible(kResearch);
    broken->setVisible(kResearch);
    return box;
}

Settings SettingsDialog::settings() const
{
    Settings out = m_start;
    out.language = m_language->currentData().toString();
    out.theme = static_cast<Theme>(m_theme->currentData().toInt());
    out.touchSized = m_touch->isChecked();
    out.units = static_cast<UnitSystem>(m_units->currentData().toInt());
    out.coordinates = static_cast<CoordinateFormat>(m_coordinates->currentData().toInt());
    out.speakAlerts = m_speak->isChecked();
    out.systemId = m_systemId->value();
    out.componentId = m_componentId->value();
    out.defaultLink = m_link->text();
    out.record = m_record->isChecked();
    out.recordFolder = m_folder->text();
    out.allowResearch = m_research->isChecked();
    out.weakestSuite = static_cast<crypto::SuiteId>(m_weakest->currentData().toInt());
    out.requireSealed = m_required->isChecked();
    return out;
}

} // namespace skyseal::ui

#include "moc_settings_dialog.cpp"
