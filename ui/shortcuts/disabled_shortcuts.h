// Says why a shortcut does nothing: Qt ignores the keys of a disabled action without a word. Lives on the GUI thread.
#pragma once

#include <QtCore/QObject>
#include <QtCore/QString>

class QWidget;

namespace skyseal::ui {

class Shortcuts;

class DisabledShortcuts : public QObject
{
    Q_OBJECT

public:
    /// For the actions that `shortcuts` has now, in `window`, which becomes the parent. `shortcuts` must outlive it.
    DisabledShortcuts(const Shortcuts &shortcuts, QWidget &window);

Q_SIGNALS:
    /// The keys of a disabled action were pressed. The line has its name and the reason.
    void refused(const QString &line);
};

} // namespace skyseal::ui
