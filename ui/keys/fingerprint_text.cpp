#include "ui/keys/fingerprint_text.h"

#include "core/keys/public_key_text.h"
#include "ui/text/vehicle_text.h"

#include <QtGui/QFontDatabase>

namespace skyseal::ui {

QString fingerprintLines(const channel::PublicKey &key, int groupsInALine)
{
    QString text = fromStd(keys::fingerprint(key));
    const qsizetype step = groupsInALine * 5; // four digits and a blank
    for (qsizetype end = step - 1; end < text.size(); end += step)
        text[end] = QLatin1Char('\n');
    return text;
}

QLabel *fixedWidthLabel(const QString &text, const char *objectName, const QString &accessibleName, QWidget *parent)
{
    auto *label = new QLabel(text, parent);
    label->setObjectName(QLatin1String(objectName));
    label->setAccessibleName(accessibleName);
    label->setTextFormat(Qt::PlainText);
    label->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    return label;
}

} // namespace skyseal::ui
