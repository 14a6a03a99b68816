#include "ui/messages/messages_panel.h"

#include "core/engine/text/event_text.h"
#include "ui/control_action.h"
#include "ui/empty_text.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/grid.h"

#include <QtGui/QAction>
#include <QtGui/QClipboard>
#include <QtGui/QGuiApplication>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QTreeView>

namespace skyseal::ui {

namespace {

/// The source is the vehicle for its own texts alone; an event of the station names the vehicle in its sentence.
Message messageOf(const engine::Event &event, const engine::EventText &text, const QString &words)
{
    const auto *received = std::get_if<vehicle::TextReceived>(&event);
    return {QDateTime::currentDateTime(), received ? received->systemId : std::uint8_t{}, text.severity, words};
}

QString sentenceOf(const engine::Event &event, const engine::EventText &text)
{
    return std::holds_alternative<vehicle::TextReceived>(event) ? text.sentence : text.line();
}

} // namespace

MessagesPanel::MessagesPanel(QWidget *parent) : DockPanel(parent)
{
    m_filter.setSourceModel(&m_model);
    m_view = new QTreeView(this);
    m_view->setObjectName(QStringLiteral("messageView"));
    m_view->setAccessibleName(tr("Messages"));
    m_view->setModel(&m_filter);
    m_view->setRootIsDecorated(false);
    m_view->setUniformRowHeights(true);
    m_view->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_view->setFrameShape(QFrame::NoFrame);
    new EmptyText(*m_view, m_model, tr("Messages of vehicles and of the station are listed here."), "messagesEmpty");
    QHeaderView *header = m_view->header();
    header->setSectionResizeMode(QHeaderView::Fixed);
    const QFontMetrics metrics(font());
    header->resizeSection(MessageModel::Time, metrics.horizontalAdvance(QStringLiteral("88:88:88.888")) + 3 * kGrid);
    header->resizeSection(MessageModel::Vehicle, metrics.horizontalAdvance(tr("station")) + 3 * kGrid);
    header->resizeSection(MessageModel::Severity, metrics.horizontalAdvance(severityText(0)) + 3 * kGrid);
    header->setStretchLastSection(true);

    auto *copy = new QAction(tr("Copy"), m_view);
    copy->setShortcut(QKeySequence::Copy);
    copy->setShortcutContext(Qt::WidgetShortcut);
    connect(copy, &QAction::triggered, this, &MessagesPanel::copySelected);
    m_view->addAction(copy);
    m_view->setContextMenuPolicy(Qt::ActionsContextMenu);
    // A hidden view has no range: the operator's position counts only while it can be seen.
    QScrollBar *bar = m_view->verticalScrollBar();
    connect(bar, &QScrollBar::valueChanged, this, [this, bar](int value) {
        if (m_view->isVisible())
            m_followsNewest = value >= bar->maximum();
    });
    connect(bar, &QScrollBar::rangeChanged, this, [this, bar](int, int maximum) {
        if (m_followsNewest)
            bar->setValue(maximum);
    });

    auto *wanted = new QLineEdit(this);
    wanted->setObjectName(QStringLiteral("messageFilter"));
    wanted->setPlaceholderText(tr("Filter"));
    wanted->setAccessibleName(tr("Filter messages"));
    wanted->setClearButtonEnabled(true);
    connect(wanted, &QLineEdit::textChanged, this, [this](const QString &text) { m_filter.setWantedText(text); });
    auto *grave = new QComboBox(this);
    grave->setObjectName(QStringLiteral("messageSeverity"));
    grave->setAccessibleName(tr("Minimum severity shown"));
    grave->addItem(tr("all"), 7);
    grave->addItem(tr("notices and above"), 5);
    grave->addItem(tr("warnings and above"), 4);
    grave->addItem(tr("errors and above"), 3);
    connect(grave, &QComboBox::currentIndexChanged, this,
            [this, grave] { m_filter.setLeastGrave(grave->currentData().toInt()); });
    auto *copyButton = new QPushButton(tr("Copy"), this);
    copyButton->setObjectName(QStringLiteral("messageCopy"));
    copyButton->setAccessibleName(tr("Copy the messages"));
    connect(copyButton, &QPushButton::clicked, this, &MessagesPanel::copySelected);
    auto *clear = new QPushButton(tr("Clear"), this);
    clear->setObjectName(QStringLiteral("messageClear"));
    clear->setAccessibleName(tr("Clear the messages"));
    connect(clear, &QPushButton::clicked, &m_model, &MessageModel::clear);
    addActions({focusAction(*wanted, tr("Find a message"), QKeySequence::Find),
                pressAction(*copyButton, Qt::ALT | Qt::SHIFT | Qt::Key_O),
                pressAction(*clear, Qt::ALT | Qt::SHIFT | Qt::Key_K)});

    auto *tools = new QHBoxLayout;
    tools->setSpacing(kGrid);
    tools->addWidget(wanted, 1);
    tools->addWidget(grave);
    tools->addWidget(copyButton);
    tools->addWidget(clear);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
    column->setSpacing(kGrid);
    column->addLayout(tools);
    column->addWidget(m_view, 1);
}

void MessagesPanel::handleEvent(const engine::Event &event)
{
    m_peers.note(event);
    if (countRefusal(event))
        return;
    const engine::EventText text = engine::eventText(event, m_peers);
    if (!text.isRoutine)
        append(messageOf(event, text, withRemedy(text, sentenceOf(event, text))));
}

void MessagesPanel::handleReplayEvent(const engine::Event &event)
{
    const engine::EventText text = engine::eventText(event, {});
    if (!text.isRoutine)
        append(messageOf(event, text, tr("Replay: %1").arg(sentenceOf(event, text))));
}

/// Under a flood of refused frames the station reports once a second: the line of the first report counts them, so that it does
/// not bury the others. A pause of a minute begins a new line.
bool MessagesPanel::countRefusal(const engine::Event &event)
{
    constexpr qint64 kPause = 60;
    constexpr qsizetype kMostKinds = 1000;
    engine::Event sum = event;
    std::uint64_t *frames = nullptr;
    QString kind;
    if (auto *clear = std::get_if<engine::PlaintextRefused>(&sum); clear && clear->mayBe.empty()) {
        frames = &clear->frames;
        kind = QStringLiteral("plain %1").arg(clear->systemId);
    } else if (auto *system = std::get_if<engine::SystemRefused>(&sum)) {
        frames = &system->frames;
        kind = QStringLiteral("system %1 %2").arg(system->systemId).arg(fromStd(system->peer));
    } else {
        return false;
    }
    if (m_refusals.size() >= kMostKinds && !m_refusals.contains(kind))
        m_refusals.clear();
    const QDateTime now = QDateTime::currentDateTime();
    RefusalLine &line = m_refusals[kind];
    const bool goesOn = line.frames > 0 && line.last.secsTo(now) < kPause;
    line.frames = *frames += goesOn ? line.frames : 0;
    line.last = now;
    const engine::EventText text = engine::eventText(sum, m_peers);
    const Message message = messageOf(sum, text, withRemedy(text, sentenceOf(sum, text)));
    if (!goesOn || !m_model.replace(line.number, message))
        line.number = append(message);
    return true;
}

/// The words and the menu where the operator can act on them.
QString MessagesPanel::withRemedy(const engine::EventText &text, const QString &words)
{
    switch (text.remedy) {
    case engine::EventText::Remedy::None: break;
    case engine::EventText::Remedy::AllowPlaintext:
        return tr("%1. To accept it, choose Security → Allow plain MAVLink").arg(words);
    case engine::EventText::Remedy::PairAgent: return tr("%1. To pair with it, open Security → Keys and peers").arg(words);
    }
    return words;
}

void MessagesPanel::showCommandResult(const QString &line, bool ok)
{
    append(
        {QDateTime::currentDateTime(), 0, std::uint8_t(ok ? mavlink::MAV_SEVERITY_INFO : mavlink::MAV_SEVERITY_WARNING), line});
}

std::uint64_t MessagesPanel::append(const Message &message)
{
    const std::uint64_t number = m_model.append(message);
    if (m_followsNewest)
        m_view->scrollToBottom();
    return number;
}

void MessagesPanel::copySelected() const
{
    QStringList lines;
    const bool some = m_view->selectionModel()->hasSelection();
    for (int row = 0; row < m_filter.rowCount(); ++row) {
        if (some && !m_view->selectionModel()->isRowSelected(row, {}))
            continue;
        QStringList cells;
        for (int column = 0; column < MessageModel::Columns; ++column)
            cells << m_filter.index(row, column).data().toString();
        lines << cells.join(QLatin1Char('\t'));
    }
    QGuiApplication::clipboard()->setText(lines.join(QLatin1Char('\n')));
}

} // namespace skyseal::ui

#include "moc_messages_panel.cpp"
