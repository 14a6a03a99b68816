#include "ui/overlays/overlay_file.h"

#include <QtCore/QSettings>

namespace skyseal::ui {

namespace {

QString overlayKey(int number, const char *key)
{
    return QStringLiteral("overlays/%1/%2").arg(number).arg(QLatin1String(key));
}

} // namespace

QList<OverlayFile> loadOverlays(const QSettings &store)
{
    QList<OverlayFile> out;
    for (int i = 1; i <= kMostOverlays; ++i) {
        OverlayFile file{.path = store.value(overlayKey(i, "path")).toString()};
        if (file.path.isEmpty())
            break;
        file.visible = store.value(overlayKey(i, "visible"), true).toBool();
        const int color = store.value(overlayKey(i, "color")).toInt();
        file.color = static_cast<OverlayColor>(color >= 0 && color < kOverlayColors ? color : 0);
        file.digest = QByteArray::fromHex(store.value(overlayKey(i, "digest")).toString().toLatin1());
        out << file;
    }
    return out;
}

void storeOverlays(QSettings &store, const QList<OverlayFile> &files)
{
    store.remove(QStringLiteral("overlays"));
    for (int i = 1; i <= files.size(); ++i) {
        const OverlayFile &file = files[i - 1];
        store.setValue(overlayKey(i, "path"), file.path);
        store.setValue(overlayKey(i, "visible"), file.visible);
        store.setValue(overlayKey(i, "color"), static_cast<int>(file.color));
        store.setValue(overlayKey(i, "digest"), QString::fromLatin1(file.digest.toHex()));
    }
}

} // namespace skyseal::ui
