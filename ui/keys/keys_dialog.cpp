#include "ui/keys/keys_dialog.h"

#include "ui/confirm_box.h"
#include "ui/keys/fingerprint_text.h"
#include "ui/keys/own_key_box.h"
#include "ui/keys/peer_dialog.h"
#include "ui/modeless.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtGui/QAction>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QStackedWidget>
#include <QtWidgets/QTreeView>
#include <QtWidgets/QVBoxLayout>

namespace skyseal::ui {

namespace {

QTreeView *makeView(PeerModel &model, QWidget *parent)
{
    auto *view = new QTreeView(parent);
    view->setObjectName(QStringLiteral("peerView"));
    view->setAccessibleName(QObject::tr("Known peers"));
    view->setModel(&model);
    view->setRootIsDecorated(false);
    view->setUniformRowHeights(true);
    view->setAllColumnsShowFocus(true);
    view->setAlternatingRowColors(true);
    view->setTabKeyNavigation(false);
    const auto room = [view](const QString &sample) { return view->fontMetrics().horizontalAdvance(sample) + 3 * kGrid; };
    view->header()->resizeSection(PeerModel::Name, room(QStringLiteral("with a pre-shared key")));
    view->header()->resizeSection(PeerModel::Systems, room(QStringLiteral("Systems")));
    view->header()->resizeSection(PeerModel::LastSeen, room(QStringLiteral("12/24/2026 12:00 PM")));
    view->header()->setStretchLastSection(true);
    return view;
}

} // namespace

KeysDialog::KeysDialog(KeyringInterface &keyring, QWidget *parent) : QDialog(parent), m_keyring(keyring)
{
    setObjectName(QStringLiteral("keysDialog"));
    setWindowTitle(tr("Keys and peers"));
    m_own = new OwnKeyBox(keyring, this);
    m_view = makeView(m_model, this);
    m_empty = new QLabel(tr("No peers yet.\n\nAdd the public key of the agent beside your vehicle; skyseal-cli keys show "
                            "prints it there. The agent also needs the key of this station."),
                         this);
    m_empty->setObjectName(QStringLiteral("noPeers"));
    m_empty->setWordWrap(true);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_pages = new QStackedWidget(this);
    m_pages->addWidget(m_view);
    m_pages->addWidget(m_empty);
    m_file = new QLabel(this);
    m_file->setForegroundRole(QPalette::PlaceholderText);
    m_file->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_problem = new QLabel(this);
    m_problem->setObjectName(QStringLiteral("keysProblem"));
    m_problem->setTextFormat(Qt::PlainText);
    m_problem->setWordWrap(true);

    const auto button = [this](const QString &text, const char *name, const QString &accessible) {
        auto *out = new QPushButton(text, this);
        out->setObjectName(QLatin1String(name));
        out->setAccessibleName(accessible);
        out->setAutoDefault(false);
        return out;
    };
    m_add = button(tr("&Add…"), "peerAdd", tr("Add a peer"));
    m_pair = button(tr("&Pair…"), "peerPair", tr("Pair with an agent"));
    m_change = button(tr("&Edit…"), "peerEdit", tr("Edit the selected peer"));
    m_revoke = button(tr("&Revoke…"), "peerRevoke", tr("Revoke the selected peer"));
    m_pair->hide();
    auto *tools = new QHBoxLayout;
    tools->setSpacing(kGrid);
    for (QPushButton *tool : {m_add, m_pair, m_change, m_revoke})
        tools->addWidget(tool);
    tools->addStretch(1);
    auto *peers = new QGroupBox(tr("Known peers"), this);
    auto *inner = new QVBoxLayout(peers);
    inner->setContentsMargins(2 * kGrid, kGrid, 2 * kGrid, 2 * kGrid);
    inner->setSpacing(kGrid);
    inner->addWidget(m_pages, 1);
    inner->addLayout(tools);
    inner->addWidget(m_file);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(2 * kGrid, 2 * kGrid, 2 * kGrid, 2 * kGrid);
    column->setSpacing(kGrid);
    column->addWidget(m_own);
    column->addWidget(peers, 1);
    column->addWidget(m_problem);
    column->addWidget(buttons);

    connect(m_add, &QPushButton::clicked, this, &KeysDialog::addPeer);
    connect(m_pair, &QPushButton::clicked, this, &KeysDialog::pairRequested);
    connect(m_change, &QPushButton::clicked, this, &KeysDialog::changePeer);
    connect(m_revoke, &QPushButton::clicked, this, &KeysDialog::revokePeer);
    connect(m_view, &QTreeView::activated, this, &KeysDialog::changePeer);
    auto *remove = new QAction(m_view);
    remove->setShortcut(QKeySequence::Delete);
    remove->setShortcutContext(Qt::WidgetShortcut);
    m_view->addAction(remove);
    connect(remove, &QAction::triggered, this, &KeysDialog::revokePeer);
    connect(m_view->selectionModel(), &QItemSelectionModel::currentChanged, this, &KeysDialog::refresh);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(&keyring, &KeyringInterface::changed, this, &KeysDialog::refresh);
    resize(104 * kGrid, 72 * kGrid);
    refresh();
}

void KeysDialog::offerPairing()
{
    m_pair->show();
    m_empty->setText(
        tr("No peers yet.\n\nPair with the agent of your vehicle, or add its public key, which skyseal-cli keys show prints "
           "there."));
}

const KnownPeer *KeysDialog::chosen() const
{
    return m_model.peerAt(m_view->currentIndex().row());
}

void KeysDialog::refresh()
{
    m_own->refresh();
    PeerList list = m_keyring.peerList();
    const KnownPeer *before = chosen();
    const QString name = before ? before->name : QString();
    m_model.setPeers(std::move(list.peers));
    if (const int row = m_model.rowOf(name); row >= 0 && row != m_view->currentIndex().row())
        m_view->setCurrentIndex(m_model.index(row, 0));
    else if (row < 0 && m_model.rowCount() > 0)
        m_view->setCurrentIndex(m_model.index(0, 0)); // the first peer, or the remaining one
    m_pages->setCurrentWidget(m_model.rowCount() > 0 || !list.problem.isEmpty() ? static_cast<QWidget *>(m_view) : m_empty);
    m_file->setText(list.file);
    notify(list.problem);
    const bool usable = list.problem.isEmpty() && !list.file.isEmpty();
    m_add->setEnabled(usable);
    m_pair->setEnabled(usable && m_keyring.ownKey().publicKey.has_value());
    for (QPushButton *tool : {m_change, m_revoke})
        tool->setEnabled(usable && chosen());
}

void KeysDialog::notify(const QString &problem)
{
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, stateColors(palette()).alarm);
    m_problem->setPalette(colors);
    m_problem->setText(problem);
    m_problem->setVisible(!problem.isEmpty());
}

void KeysDialog::addPeer()
{
    auto *dialog = new PeerDialog(m_keyring, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    showModeless(*dialog);
}

void KeysDialog::changePeer()
{
    const KnownPeer *peer = chosen();
    if (!peer || !m_change->isEnabled())
        return;
    auto *dialog = new PeerDialog(m_keyring, *peer, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    showModeless(*dialog);
}

void KeysDialog::revokePeer()
{
    const KnownPeer *peer = chosen();
    if (!peer || !m_revoke->isEnabled())
        return;
    const QString name = peer->name;
    const QString end = peer->connected ? tr("Its session ends at once, and it can no longer connect.")
                                        : tr("It can no longer connect.");
    const QString armed = m_armedOf ? m_armedOf(name) : QString();
    const bool areSeveral = armed.contains(QLatin1Char(','));
    const QString text = armed.isEmpty() ? tr("Revoke %1?").arg(name)
        : areSeveral                     ? tr("Vehicles %1 are armed. Revoke %2?").arg(armed, name)
                                         : tr("Vehicle %1 is armed. Revoke %2?").arg(armed, name);
    const QString loss = armed.isEmpty() ? QString()
        : areSeveral                     ? tr("They cannot be commanded from here then, and failsafes may trigger.")
                                         : tr("It cannot be commanded from here then, and failsafes may trigger.");
    QStringList details{end, fingerprintLines(peer->key, 4)};
    if (!loss.isEmpty())
        details.insert(1, loss);
    askToConfirm({.objectName = QStringLiteral("confirmRevoke"),
                  .title = tr("Revoke %1?").arg(name),
                  .text = text,
                  .details = details.join(QStringLiteral("\n\n")),
                  .yes = tr("Revoke"),
                  .icon = QMessageBox::Warning},
                 this, this, [this, name] {
                     if (const auto removed = m_keyring.removePeer(name); !removed)
                         notify(reasonText(removed.error().reason()));
                 });
}

} // namespace skyseal::ui

#include "moc_keys_dialog.cpp"
