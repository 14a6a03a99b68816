#include "ui/values/values_editor.h"

#include "ui/empty_text.h"
#include "ui/form_scroll.h"
#include "ui/list_keys.h"
#include "ui/theme/form_pieces.h"
#include "ui/theme/grid.h"
#include "ui/theme/instrument_style.h"
#include "ui/theme/palettes.h"
#include "ui/values/source_model.h"

#include <QtGui/QKeyEvent>
#include <QtGui/QShortcut>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QFormLayout>
#include <QtWidgets/QGroupBox>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSpinBox>
#include <QtWidgets/QTreeView>
#include <QtWidgets/QVBoxLayout>

#include <cmath>
#include <utility>

namespace skyseal::ui {

namespace {

/// A limit as it was typed: nullopt for an empty text. Fails if it is not a finite number.
tl::expected<std::optional<double>, QString> typedLimit(const QString &typed)
{
    QString text = typed.trimmed();
    if (text.isEmpty())
        return std::optional<double>();
    text.replace(QLatin1Char(','), QLatin1Char('.')).replace(QChar(0x2212), QLatin1Char('-'));
    bool ok = false;
    const double number = text.toDouble(&ok);
    if (!ok || !std::isfinite(number))
        return tl::unexpected(typed);
    return std::optional(number);
}

QPushButton *makeButton(const QString &text, const char *name, QWidget *parent)
{
    auto *button = new QPushButton(text, parent);
    button->setObjectName(QLatin1String(name));
    button->setAutoDefault(false);
    return button;
}

} // namespace

ValuesEditor::ValuesEditor(const ValueChoices &choices, UnitSystem units, QWidget *parent)
    : QDialog(parent), m_choices(choices), m_units(units), m_sources(new SourceModel(this))
{
    setObjectName(QStringLiteral("valuesEditor"));
    setWindowTitle(tr("Edit values"));
    auto *top = new QHBoxLayout;
    top->setSpacing(2 * kGrid);
    top->addWidget(makeChosen(), 1);
    top->addWidget(makeDetails(), 1);
    auto *form = new QWidget(this);
    auto *inner = new QVBoxLayout(form);
    inner->setContentsMargins(0, 0, 0, 0);
    inner->setSpacing(kGrid);
    inner->addLayout(top, 1);
    inner->addWidget(makeFinder(), 1);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(2 * kGrid, 2 * kGrid, 2 * kGrid, 2 * kGrid);
    column->setSpacing(kGrid);
    column->addWidget(new FormScroll(form), 1);
    m_problem = named(new QLabel(this), "editorProblem", tr("Problem"));
    column->addWidget(m_problem);
    column->addWidget(makeButtons());
    resize(92 * kGrid, 74 * kGrid);
    if (leastTarget(*this) > 0)
        fitToScreen(*this);
    fillList(m_choices.empty() ? -1 : 0);
    m_found->setCurrentIndex(m_sources->index(0, 0));
    updateButtons();
    m_find->setFocus();
}

QWidget *ValuesEditor::makeChosen()
{
    auto *box = new QGroupBox(tr("Chosen values"), this);
    m_list = named(new QListWidget(box), "editorList", tr("Chosen values"));
    auto *label = new QLabel(tr("&Values, in the order of the grid"), box);
    label->setBuddy(m_list);
    m_remove = makeButton(tr("&Remove"), "editorRemove", box);
    m_up = makeButton(tr("&Up"), "editorUp", box);
    m_down = makeButton(tr("&Down"), "editorDown", box);
    auto *buttons = new QHBoxLayout;
    for (QPushButton *button : {m_remove, m_up, m_down})
        buttons->addWidget(button);
    auto *column = new QVBoxLayout(box);
    column->addWidget(label);
    column->addWidget(m_list, 1);
    column->addLayout(buttons);
    connect(m_list, &QListWidget::currentRowChanged, this, &ValuesEditor::showDetails);
    connect(m_remove, &QPushButton::clicked, this, &ValuesEditor::removeCurrent);
    connect(new QShortcut(QKeySequence::Delete, m_list, nullptr, nullptr, Qt::WidgetShortcut), &QShortcut::activated, this,
            &ValuesEditor::removeCurrent);
    connect(m_up, &QPushButton::clicked, this, [this] { moveCurrent(-1); });
    connect(m_down, &QPushButton::clicked, this, [this] { moveCurrent(1); });
    return box;
}

QWidget *ValuesEditor::makeDetails()
{
    auto *box = new QGroupBox(tr("The selected value"), this);
    m_source = named(new QLabel(box), "editorSource", tr("Source"));
    m_source->setTextFormat(Qt::PlainText);
    m_source->setWordWrap(true);
    m_source->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_source->setMinimumHeight(3 * QFontMetrics(font()).lineSpacing()); // nothing moves when another one is selected
    m_caption = named(new QLineEdit(box), "editorCaption", tr("Caption"));
    m_caption->setMaxLength(kLongestCaption);
    m_element = named(new QSpinBox(box), "editorElement", tr("Element of the array"));
    m_unit = named(new QLineEdit(box), "editorUnit", tr("Unit"));
    m_unit->setMaxLength(kLongestUnit);
    m_decimals = named(new QSpinBox(box), "editorDecimals", tr("Decimals"));
    m_decimals->setRange(-1, kMostDecimals);
    m_decimals->setSpecialValueText(tr("automatic"));
    m_low = named(new QLineEdit(box), "editorLow", tr("Low limit"));
    m_high = named(new QLineEdit(box), "editorHigh", tr("High limit"));
    m_line = named(new QCheckBox(tr("L&ine of the last minute"), box), "editorLine", tr("Line of the last minute"));
    m_lowUnit = new QLabel(box);
    m_highUnit = new QLabel(box);
    auto *form = new QFormLayout(box);
    form->addRow(m_source);
    form->addRow(tr("&Caption"), m_caption);
    form->addRow(tr("&Element"), m_element);
    form->addRow(tr("U&nit"), m_unit);
    form->addRow(tr("Deci&mals"), m_decimals);
    for (const auto &[text, edit, unit] :
         {std::tuple(tr("&Low below"), m_low, m_lowUnit), std::tuple(tr("&High above"), m_high, m_highUnit)}) {
        edit->setPlaceholderText(tr("no limit"));
        auto *line = new QHBoxLayout;
        line->addWidget(edit, 1);
        line->addWidget(unit);
        unit->setMinimumWidth(QFontMetrics(font()).horizontalAdvance(QStringLiteral("ft/min")));
        auto *label = new QLabel(text, box);
        label->setBuddy(edit);
        form->addRow(label, line);
        connect(edit, &QLineEdit::textEdited, this, &ValuesEditor::readLimits);
    }
    form->addRow(QString(), m_line);
    connect(m_caption, &QLineEdit::textEdited, this,
            [this](const QString &text) { editCurrent([&](ValueChoice &choice) { choice.caption = text.trimmed(); }); });
    connect(m_unit, &QLineEdit::textEdited, this, [this](const QString &text) {
        editCurrent([&](ValueChoice &choice) { choice.unitText = text.trimmed(); });
        for (QLabel *label : {m_lowUnit, m_highUnit})
            label->setText(text.trimmed());
    });
    connect(m_element, &QSpinBox::valueChanged, this, [this](int element) {
        editCurrent([&](ValueChoice &choice) { choice.source.element = static_cast<std::uint8_t>(element); });
    });
    connect(m_decimals, &QSpinBox::valueChanged, this,
            [this](int decimals) { editCurrent([&](ValueChoice &choice) { choice.decimals = decimals; }); });
    connect(m_line, &QCheckBox::toggled, this,
            [this](bool on) { editCurrent([&](ValueChoice &choice) { choice.line = on; }); });
    return box;
}

QWidget *ValuesEditor::makeFinder()
{
    auto *box = new QGroupBox(tr("All values"), this);
    m_find = named(new QLineEdit(box), "editorFind", tr("Find a value"));
    m_find->setPlaceholderText(tr("Parts of a name, such as \"roll\" or \"battery volt\""));
    m_find->setClearButtonEnabled(true);
    m_find->installEventFilter(this);
    auto *label = new QLabel(tr("&Find"), box);
    label->setBuddy(m_find);
    m_found = named(new QTreeView(box), "editorFound", tr("Matching values"));
    m_found->setModel(m_sources);
    new EmptyText(*m_found, *m_sources, tr("No value has these words in its name."), "editorFoundEmpty");
    m_found->setRootIsDecorated(false);
    m_found->setUniformRowHeights(true);
    m_found->setFocusPolicy(Qt::NoFocus); // the arrows move the selection while one types
    m_found->header()->setStretchLastSection(true);
    const QFontMetrics metrics(font());
    m_found->header()->resizeSection(
        SourceModel::Name, metrics.horizontalAdvance(QStringLiteral("BATTERY_INFO.charging_minimum_voltage")) + 2 * kGrid);
    m_found->header()->resizeSection(SourceModel::Unit, metrics.horizontalAdvance(QStringLiteral("cm^3/min")) + 2 * kGrid);
    m_add = makeButton(tr("&Add"), "editorAdd", box);
    m_use = makeButton(tr("Use for the &selected value"), "editorUse", box);
    auto *line = new QHBoxLayout;
    line->addWidget(label);
    line->addWidget(m_find, 1);
    line->addWidget(m_add);
    line->addWidget(m_use);
    auto *column = new QVBoxLayout(box);
    column->addLayout(line);
    column->addWidget(m_found, 1);
    connect(m_find, &QLineEdit::textChanged, this, [this](const QString &typed) {
        m_sources->filter(typed);
        m_found->setCurrentIndex(m_sources->index(0, 0));
        updateButtons();
    });
    connect(m_found, &QTreeView::doubleClicked, this, &ValuesEditor::addFound);
    connect(m_add, &QPushButton::clicked, this, &ValuesEditor::addFound);
    connect(m_use, &QPushButton::clicked, this, &ValuesEditor::useFound);
    return box;
}

QWidget *ValuesEditor::makeButtons()
{
    auto *row = new QWidget(this);
    auto *usual = makeButton(tr("Defaul&ts"), "editorUsual", row);
    usual->setToolTip(tr("Restores the default values; takes effect with Apply or OK"));
    auto *box = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Apply | QDialogButtonBox::Cancel, row);
    m_apply = box->button(QDialogButtonBox::Apply);
    m_apply->setText(tr("A&pply"));
    m_apply->setObjectName(QStringLiteral("editorApply"));
    m_apply->setAutoDefault(false);
    m_ok = box->button(QDialogButtonBox::Ok);
    m_ok->setText(tr("OK"));
    box->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
    auto *line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(usual);
    line->addStretch(1);
    line->addWidget(box);
    connect(usual, &QPushButton::clicked, this, [this] {
        m_choices = defaultValues();
        fillList(0);
    });
    connect(m_apply, &QPushButton::clicked, this, [this] { Q_EMIT applied(m_choices); });
    connect(box, &QDialogButtonBox::accepted, this, [this] {
        Q_EMIT applied(m_choices);
        accept();
    });
    connect(box, &QDialogButtonBox::rejected, this, &QDialog::reject);
    return row;
}

QString ValuesEditor::itemText(const ValueChoice &choice)
{
    return choice.shownCaption() + QStringLiteral(" · ") + choice.source.title();
}

void ValuesEditor::fillList(int current)
{
    {
        const QSignalBlocker blocker(m_list);
        m_list->clear();
        for (const ValueChoice &choice : m_choices)
            m_list->addItem(itemText(choice));
        m_list->setCurrentRow(current);
    }
    showDetails();
}

ValueChoice *ValuesEditor::current()
{
    const int row = m_list->currentRow();
    return row >= 0 && static_cast<std::size_t>(row) < m_choices.size() ? &m_choices[static_cast<std::size_t>(row)] : nullptr;
}

const ValueSource *ValuesEditor::found() const
{
    const QModelIndex at = m_found->currentIndex();
    return at.isValid() ? &m_sources->sourceAt(at.row()) : nullptr;
}

void ValuesEditor::showDetails()
{
    m_filling = true;
    const ValueChoice *choice = current();
    const bool isNumber = choice && choice->source.isNumber();
    const ValueUnit unit = choice ? choice->shownUnit() : ValueUnit();
    const bool takesUnit = choice && choice->source.takesUnit();
    QString about;
    if (choice) {
        about = choice->source.title() + QLatin1Char('\n') + choice->source.description();
        const QString sent = choice->source.sourceUnit(), shown = unitName(unit, m_units);
        if (!sent.isEmpty() && sent != shown)
            about += QLatin1Char('\n') + tr("%1, shown in %2").arg(sent, shown);
        else if (!sent.isEmpty())
            about += QLatin1Char('\n') + sent;
    }
    m_source->setText(choice ? about : tr("Nothing is selected. Find a value below and add it."));
    m_caption->setText(choice ? choice->caption : QString());
    m_caption->setPlaceholderText(choice ? choice->source.caption() : QString());
    m_unit->setText(isNumber ? unitName(unit, m_units) : QString());
    m_unit->setPlaceholderText(takesUnit ? tr("none") : QString());
    m_unit->setToolTip(isNumber && !takesUnit ? tr("The unit of the message's definition, in the chosen system of units")
                                              : QString());
    m_element->setRange(0, choice ? static_cast<int>(choice->source.elements()) - 1 : 0);
    m_element->setValue(choice ? choice->source.element : 0);
    m_decimals->setValue(choice ? choice->decimals : -1);
    const double factor = unitFactor(unit, m_units);
    const auto limit = [&](const std::optional<double> &metric) {
        return metric ? withDecimalPoint(QString::number(*metric * factor, 'g', 8)) : QString();
    };
    m_low->setText(choice ? limit(choice->low) : QString());
    m_high->setText(choice ? limit(choice->high) : QString());
    for (QLabel *label : {m_lowUnit, m_highUnit})
        label->setText(isNumber ? unitName(unit, m_units) : QString());
    m_line->setChecked(choice && choice->line);
    m_caption->setEnabled(choice);
    m_element->setEnabled(choice && choice->source.elements() > 1);
    m_unit->setEnabled(takesUnit);
    for (QWidget *field : std::initializer_list<QWidget *>{m_decimals, m_low, m_high, m_line})
        field->setEnabled(isNumber);
    m_filling = false;
    readLimits();
}

void ValuesEditor::editCurrent(const std::function<void(ValueChoice &)> &change)
{
    ValueChoice *choice = current();
    if (m_filling || !choice)
        return;
    change(*choice);
    m_list->currentItem()->setText(itemText(*choice));
    m_caption->setPlaceholderText(choice->source.caption());
}

/// Takes over the limits if they are sound; else says why not, and neither Apply nor OK is possible.
void ValuesEditor::readLimits()
{
    ValueChoice *choice = current();
    QString problem;
    if (choice && choice->source.isNumber()) {
        const auto low = typedLimit(m_low->text()), high = typedLimit(m_high->text());
        if (!low || !high)
            problem = tr("▲ \"%1\" is not a number").arg(!low ? low.error() : high.error());
        else if (*low && *high && **low >= **high)
            problem = tr("▲ The low limit must be below the high one");
        else {
            const double factor = unitFactor(choice->source.unit(), m_units);
            const auto metric = [factor](std::optional<double> shown) {
                return shown ? std::optional(*shown / factor) : std::nullopt;
            };
            // Unchanged texts keep the limits bit for bit.
            if (m_low->isModified())
                choice->low = metric(*low);
            if (m_high->isModified())
                choice->high = metric(*high);
        }
    }
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, stateColors(palette()).alarm);
    m_problem->setPalette(colors);
    m_problem->setText(problem);
    updateButtons();
}

void ValuesEditor::addFound()
{
    const ValueSource *source = found();
    if (!source || m_choices.size() >= kMostValues)
        return;
    m_choices.push_back({.source = *source});
    fillList(static_cast<int>(m_choices.size()) - 1);
}

void ValuesEditor::useFound()
{
    ValueChoice *choice = current();
    if (const ValueSource *source = found(); source && choice) {
        *choice = {.source = *source};
        fillList(m_list->currentRow());
    }
}

void ValuesEditor::removeCurrent()
{
    if (!current())
        return;
    const int row = m_list->currentRow();
    m_choices.erase(m_choices.begin() + row);
    fillList(std::min(row, static_cast<int>(m_choices.size()) - 1));
}

void ValuesEditor::moveCurrent(int by)
{
    const int row = m_list->currentRow(), to = row + by;
    if (row < 0 || to < 0 || to >= static_cast<int>(m_choices.size()))
        return;
    std::swap(m_choices[static_cast<std::size_t>(row)], m_choices[static_cast<std::size_t>(to)]);
    fillList(to);
}

void ValuesEditor::updateButtons()
{
    const int row = m_list->currentRow(), count = static_cast<int>(m_choices.size());
    const bool full = m_choices.size() >= kMostValues;
    m_add->setEnabled(found() && !full);
    m_add->setToolTip(full ? tr("No more than %1 values").arg(kMostValues) : tr("Adds the value that is selected below"));
    m_use->setEnabled(found() && row >= 0);
    m_remove->setEnabled(row >= 0);
    m_up->setEnabled(row > 0);
    m_down->setEnabled(row >= 0 && row + 1 < count);
    const bool sound = m_problem->text().isEmpty();
    m_apply->setEnabled(sound);
    m_ok->setEnabled(sound);
}

bool ValuesEditor::eventFilter(QObject *watched, QEvent *event)
{
    if (watched != m_find || event->type() != QEvent::KeyPress)
        return QDialog::eventFilter(watched, event);
    return takeListKey(*static_cast<QKeyEvent *>(event), *m_found, [this] { addFound(); })
        || QDialog::eventFilter(watched, event);
}

} // namespace skyseal::ui

#include "moc_values_editor.cpp"
