#include "ui/theme/suite_style.h"

#include "core/engine/text/state_text.h"

#include <QtGui/QPainter>
#include <QtGui/QPixmap>

namespace skyseal::ui {

using crypto::SuiteId;

QColor suiteColor(SuiteId suite)
{
    switch (suite) {
    case SuiteId::ChaCha20Poly1305: return QColor(0x0072B2);
    case SuiteId::Aes256Gcm: return QColor(0x009E73);
    case SuiteId::Aes256Ctr: return QColor(0x56B4E9);
    case SuiteId::Aes256Cbc: return QColor(0xCC79A7);
    case SuiteId::ChaCha20: return QColor(0xE69F00);
    case SuiteId::Rc4: return QColor(0xD55E00);
    case SuiteId::None: break;
    }
    return QColor(0x999999);
}

QString suiteName(SuiteId suite)
{
    return engine::suiteText(suite);
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
