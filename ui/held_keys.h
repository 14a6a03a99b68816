// The keys that are down, and the widget that had the focus before, so that a control can tell a press by a finger from the
// auto-repeat of a key that was pressed elsewhere, and where the focus came from.
//
// QKeyEvent::isAutoRepeat() is not enough: X11 sends a held key as pairs of a release and a press, and Qt marks only the pairs
// whose halves it reads together. The two halves carry the same time, while a finger needs longer to press a key again.
#pragma once

#include <QtCore/QHash>
#include <QtCore/QObject>
#include <QtCore/QPointer>
#include <QtCore/QSet>
#include <QtWidgets/QWidget>

class QKeyEvent;

namespace skyseal::ui {

/// Sees every key event of the program. A key that is held presses no button but the one that it was pressed in: the focus
/// moves under it when a dialog closes. Lives on the GUI thread.
class HeldKeys : public QObject
{
    Q_OBJECT

public:
    /// Milliseconds. A press that follows a release of the same key sooner belongs to a key that is held.
    static constexpr int kRepeatGapMs = 40;

    /// There is one keyboard for all windows of the program, so its state belongs to the QApplication, which must exist.
    static HeldKeys &ofProgram();

    /// The keys that press buttons.
    static bool isPressKey(int key);

    /// Returns true while `press` is delivered if the key was up before.
    bool isFresh(const QKeyEvent &press) const;
    /// False between the halves of a pair as well, until the press or released() tells which it was.
    bool isDown(int key) const { return m_down.contains(key); }
    /// The widget that lost the focus last; null if it is gone.
    const QWidget *focusLeft() const { return m_left; }

Q_SIGNALS:
    /// The key is up, or another program receives the keys now.
    void released(int key);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    struct Release
    {
        quint64 timestamp = 0; ///< of the event, milliseconds; 0 if unknown
        int number = 0;        ///< distinguishes it from later releases of the key
        bool pending = false;  ///< may still turn out to be the first half of a pair
    };

    using QObject::QObject;

    void notePress(const QKeyEvent &press);
    void noteRelease(const QKeyEvent &release);
    bool continuesHold(const QKeyEvent &press) const;
    void releaseAll();

    QSet<int> m_down;
    QHash<int, Release> m_releases;          ///< the last one of each key
    QHash<int, const QObject *> m_pressedIn; ///< the widget that got the press of each key; to compare only
    const QKeyEvent *m_fresh = nullptr;      ///< the event that pressed a key which was up; events share addresses on the stack
    quint64 m_freshAt = 0;                   ///< its timestamp
    QPointer<const QWidget> m_left;
    bool m_isHeld = false; ///< the last press certainly belongs to a key that is held
    int m_number = 0;
};

} // namespace skyseal::ui
