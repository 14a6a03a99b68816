#include "ui/links/problem_banner.h"

#include "ui/control_action.h"
#include "ui/theme/grid.h"
#include "ui/theme/icons.h"
#include "ui/theme/palettes.h"

#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>

namespace skyseal::ui {

ProblemBanner::ProblemBanner(QWidget *parent) : QFrame(parent)
{
    setObjectName(QStringLiteral("problemBanner"));
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::AlternateBase);
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(2 * kGrid, kGrid, kGrid, kGrid);
    row->setSpacing(kGrid);
    m_icon = new QLabel(this);
    m_icon->setFixedSize(16, 16);
    m_text = new QLabel(this);
    m_text->setObjectName(QStringLiteral("problemText"));
    m_text->setTextFormat(Qt::PlainText); // problems contain names of files, devices and peers
    m_text->setWordWrap(true);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_act = new QPushButton(this);
    m_act->setObjectName(QStringLiteral("problemRemedy"));
    m_act->setAccessibleName(tr("Resolve the problem"));
    m_close = new QPushButton(tr("Dismiss"), this);
    m_close->setObjectName(QStringLiteral("problemDismiss"));
    m_close->setAccessibleName(tr("Dismiss the problem"));
    m_close->setFlat(true);
    row->addWidget(m_icon);
    row->addWidget(m_text, 1);
    row->addWidget(m_act);
    row->addWidget(m_close);
    connect(m_close, &QPushButton::clicked, this, &QWidget::hide);
    connect(m_act, &QPushButton::clicked, this, [this] {
        hide();
        if (m_remedy)
            m_remedy();
    });
    addActions({pressAction(*m_act, Qt::ALT | Qt::SHIFT | Qt::Key_Y), pressAction(*m_close, Qt::ALT | Qt::SHIFT | Qt::Key_W)});
    hide();
}

void ProblemBanner::notify(const QString &problem, const QString &remedy, std::function<void()> act)
{
    m_icon->setPixmap(iconPixmap(QStringLiteral("warning"), 16, stateColors(palette()).warning, devicePixelRatioF()));
    m_text->setText(problem);
    m_remedy = std::move(act);
    m_act->setText(remedy);
    m_act->setAccessibleName(remedy);
    m_act->setVisible(!remedy.isEmpty());
    show();
}

QString ProblemBanner::problem() const
{
    return m_text->text();
}

} // namespace skyseal::ui

#include "moc_problem_banner.cpp"
