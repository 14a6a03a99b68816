#include "ui/theme/suite_style.h"

#include "core/engine/text/state_text.h"

#include <QtGui/QPainter>
#include <QtGui/QPixmap>

namespace skyseal::ui {

using crypto::SuiteId;

QColor suiteColor(SuiteId suite)
{
    return QColor(crypto::suiteInfo(suite).color);
}

QString suiteName(SuiteId suite)
{
    return engine::suiteText(suite);
}

QString suiteNameOf(const std::string &nameInFiles)
{
    const auto suite = crypto::suiteFromName(nameInFiles);
    return suite ? suiteName(*suite) : QString::fromStdString(nameInFiles);
}

QIcon suiteDot(SuiteId suite)
{
    constexpr int size = 32;
    QPixmap pixmap(size, size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(suiteColor(suite));
    painter.drawEllipse(QRectF(6, 6, size - 12, size - 12));
    painter.end();
    return QIcon(pixmap);
}

} // namespace skyseal::ui
