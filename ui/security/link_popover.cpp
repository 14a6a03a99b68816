#include "ui/security/link_popover.h"

#include "ui/text/lock_face.h"
#include "ui/theme/grid.h"
#include "ui/theme/icons.h"
#include "ui/theme/palettes.h"
#include "ui/theme/suite_style.h"

#include <QtGui/QKeyEvent>
#include <QtGui/QMouseEvent>
#include <QtWidgets/QApplication>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QVBoxLayout>

#include <algorithm>

namespace skyseal::ui {

namespace {

constexpr int kIconSize = 24;
constexpr int kWidth = 44 * kGrid;

QColor iconColorOf(const LockFace &face, const StateColors &colors)
{
    switch (face.security) {
    case engine::Security::Nothing: return face.lost ? colors.warning : colors.dim;
    case engine::Security::Plain: return colors.warning;
    case engine::Security::UnderAttack: return colors.alarm;
    case engine::Security::Sealed:
    case engine::Security::Switching: break;
    }
    return face.suite ? suiteColor(*face.suite) : colors.good;
}

void setChanged(QLabel *label, const QString &text)
{
    if (label->text() != text)
        label->setText(text);
}

} // namespace

LinkPopover::LinkPopover(QWidget &window) : QFrame(&window), m_window(window)
{
    setObjectName(QStringLiteral("linkPopover"));
    setAccessibleName(tr("Secure link"));
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setAttribute(Qt::WA_NoMousePropagation); // a click inside is none on the window below
    m_icon = new QLabel(this);
    m_icon->setFixedSize(kIconSize, kIconSize);
    m_title = new QLabel(this);
    m_title->setObjectName(QStringLiteral("popoverTitle"));
    m_title->setWordWrap(true);
    QFont strong = font();
    strong.setWeight(QFont::DemiBold);
    m_title->setFont(strong);
    m_facts = new QLabel(this);
    m_facts->setObjectName(QStringLiteral("popoverFacts"));
    m_facts->setTextFormat(Qt::PlainText);
    m_facts->setWordWrap(true);
    m_facts->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_open = new QPushButton(tr("Open secure link"), this);
    m_open->setObjectName(QStringLiteral("popoverOpen"));
    m_open->setAccessibleName(m_open->text());
    m_open->setAutoDefault(true); // Return opens it as well
    auto *head = new QHBoxLayout;
    head->setSpacing(kGrid);
    head->addWidget(m_icon, 0, Qt::AlignTop);
    head->addWidget(m_title, 1);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(2 * kGrid, 2 * kGrid, 2 * kGrid, 2 * kGrid);
    column->setSpacing(kGrid);
    column->addLayout(head);
    column->addWidget(m_facts);
    column->addWidget(m_open, 0, Qt::AlignRight);
    connect(m_open, &QPushButton::clicked, this, [this] {
        dismiss();
        Q_EMIT panelRequested();
    });
    showViewState({});
    hide();
}

void LinkPopover::toggleAt(QWidget &anchor)
{
    if (isVisible())
        return dismiss();
    m_anchor = &anchor;
    m_before = QApplication::focusWidget();
    place();
    show();
    raise();
    m_open->setFocus(Qt::PopupFocusReason);
    qApp->installEventFilter(this);
}

void LinkPopover::showViewState(const ViewState &view)
{
    const LockFace face = lockFaceOf(view);
    setChanged(m_title, face.variants.value(0));
    setChanged(m_facts, face.toolTip);
    const QPixmap picture = iconPixmap(face.icon, kIconSize, iconColorOf(face, stateColors(palette())), devicePixelRatioF());
    if (m_icon->pixmap(Qt::ReturnByValue).cacheKey() != picture.cacheKey())
        m_icon->setPixmap(picture);
    if (isVisible() && sizeHint() != size())
        place();
}

/// Below the anchor, right edges in line, within the window.
void LinkPopover::place()
{
    if (!m_anchor)
        return;
    const int width = std::min(kWidth, m_window.width() - 2 * kGrid);
    resize(width, layout()->totalHeightForWidth(width));
    const QPoint corner = m_anchor->mapTo(&m_window, QPoint(m_anchor->width(), m_anchor->height()));
    move(std::clamp(corner.x() - width, kGrid, std::max(kGrid, m_window.width() - width - kGrid)), corner.y() + 2);
}

void LinkPopover::dismiss()
{
    const bool hadFocus = isAncestorOf(QApplication::focusWidget());
    hide();
    if (hadFocus && m_before)
        m_before->setFocus(Qt::PopupFocusReason);
}

void LinkPopover::hideEvent(QHideEvent *event)
{
    qApp->removeEventFilter(this);
    QFrame::hideEvent(event);
}

/// Of the whole program while it is open. A click elsewhere goes on to what it meets.
bool LinkPopover::eventFilter(QObject *watched, QEvent *event)
{
    switch (event->type()) {
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
        if (static_cast<QKeyEvent *>(event)->key() != Qt::Key_Escape || !isAncestorOf(QApplication::focusWidget()))
            break;
        event->accept();
        if (event->type() == QEvent::KeyPress)
            dismiss();
        return true;
    case QEvent::MouseButtonPress: {
        const auto *widget = qobject_cast<QWidget *>(watched);
        // On the anchor, its own click closes.
        if (widget && widget != this && !isAncestorOf(widget) && widget != m_anchor)
            dismiss();
        break;
    }
    case QEvent::Resize:
        if (watched == &m_window || watched == m_anchor)
            place();
        break;
    case QEvent::Move:
        if (watched == m_anchor)
            place();
        break;
    default: break;
    }
    return false;
}

} // namespace skyseal::ui

#include "moc_link_popover.cpp"
