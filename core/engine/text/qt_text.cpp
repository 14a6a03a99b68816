#include "core/engine/text/qt_text.h"

#include <QtCore/QCoreApplication>

namespace skyseal::engine {

QString reasonText(const Reason &reason)
{
    return qt(reason.text([](const Sentence &sentence) {
        return QCoreApplication::translate(sentence.context(), sentence.english()).toStdString();
    }));
}

QString decimalText(double value, int decimals)
{
    const QString half = QCoreApplication::translate("skyseal::engine::Number", "0.5", "with this language's decimal point");
    return QString::number(value, 'f', decimals).replace(QLatin1Char('.'), half.mid(1, half.size() - 2));
}

} // namespace skyseal::engine
