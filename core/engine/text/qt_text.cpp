#include "core/engine/text/qt_text.h"

#include <QtCore/QCoreApplication>

namespace skyseal::engine {

QString reasonText(const Reason &reason)
{
    return qt(reason.text([](const Sentence &sentence) {
        return QCoreApplication::translate(sentence.context(), sentence.english()).toStdString();
    }));
}

} // namespace skyseal::engine
