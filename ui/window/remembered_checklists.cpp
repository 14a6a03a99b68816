#include "ui/window/remembered_checklists.h"

#include "ui/flight/preflight.h"

#include <QtCore/QSettings>

namespace skyseal::ui {

namespace {
const QString kChecklistGroup = QStringLiteral("checklists"); ///< system ids, each with the path of its file
}

void rememberChecklists(Preflight &preflight, QSettings &store)
{
    Preflight::Files files;
    store.beginGroup(kChecklistGroup);
    for (const QString &key : store.childKeys())
        if (const int systemId = key.toInt(); systemId >= 1 && systemId <= 255)
            files.insert(systemId, store.value(key).toString());
    store.endGroup();
    preflight.setFiles(files);
    QObject::connect(&preflight, &Preflight::filesChanged, &preflight, [&preflight, &store] {
        store.remove(kChecklistGroup);
        const Preflight::Files &now = preflight.files();
        for (auto file = now.begin(); file != now.end(); ++file)
            store.setValue(kChecklistGroup + QLatin1Char('/') + QString::number(file.key()), file.value());
    });
}

} // namespace skyseal::ui
