/* The live switch and the rekey (PROTOCOL.md, section 8): two ends, both proposing, over a network that loses, repeats and
   reorders, and with -DREPLACEMENT a crash of either end and a new session.

   Network: a message that was sent once can arrive at any later time, any number of times, or never; it has an effect if the
   receiver holds the keys under which it was sealed. So there is no bound on copies, and no queue. One record, which stands
   for any, is followed from its sealing to its arrival or loss (`probe`).

   Time: each timer may fire at any time, before or after any message, with one exception: the generous round trip of section 8
   has not passed while the followed record of the previous epoch is under way. Keys are numbers; two derivations have the same
   number if and only if all their inputs are equal.

   Properties:
     READABLE  whatever an end seals in any state, the other end holds the keys to read it.
     ARRIVAL   a record is readable when it arrives, if it was not delayed for longer than a generous round trip.
     FRESH     no end seals from counter 0 under the same key twice.
     DECISION  no proposal is in force at one end after its owner was notified that it failed.
     LIMIT     no more records than the hard limit are sealed under one key (with REKEY).
     PROGRESS  from every reachable state, as soon as messages get through: open proposals end, one of them in a switch unless
               it was refused; both ends settle under the same key; a further proposal of either end, and a rekey that is due,
               lead to a new epoch.

   The lines below are read by tests/proofs/prove.py: the definitions of a run, and the properties that it violates. Those with
   properties are mutants: each takes one rule out of the protocol.

   run PROPOSALS=2                                       holds
   run REFUSALS                              holds
   run REPLACEMENT                           holds
   run REKEY                                 holds
   run DROP_PREPARED             violates READABLE       the answerer wipes prepared keys when its owner is notified
   run LATE_ACCEPT               violates DECISION       the proposer commits a proposal that it gave up
   run LATE_ACCEPT               violates READABLE       the same
   run EARLY_ANSWERER            violates READABLE       the answerer sends under the next epoch before the proposer committed
   run ANSWER_BOTH               violates READABLE       the station accepts a crossing proposal and keeps its own
   run NO_WINNER                 violates PROGRESS       each end gives its own proposal up for a crossing one
   run FRESH_ANSWERS             violates READABLE       a copy of a proposal gets an answer with another key
   run ANY_ID                    violates READABLE       the answer to an earlier proposal is taken for that of the open one
   run OLD_PROPOSALS             violates READABLE       a proposal with a lower id replaces a newer one
   run WIPE_AT_ONCE              violates READABLE       the previous epoch's keys are wiped at the commit
   run SEND_PREVIOUS             violates ARRIVAL        an end seals under an epoch that it left
   run NO_SPARING                violates ARRIVAL        a proposal does not wait until the previous epoch can be spared
   run NO_SETTLING               violates PROGRESS       a proposal does not wait until the last switch is settled
   run CONFIRM_ONCE              violates PROGRESS       Confirm is not repeated
   run WAIT_FOREVER              violates PROGRESS       an end does not propose as long as a proposal of the other is undecided
   run REKEY NO_HARD_LIMIT       violates LIMIT          records are sealed beyond the hard limit
   run REKEY TRIED_ONCE          violates PROGRESS       a rekey that failed is not tried again
   run REPLACEMENT OLD_KEYS      violates FRESH          an end that crashed goes on with its old keys
*/

#ifndef PROPOSALS
#define PROPOSALS 2 /* of each end */
#endif
#define IDS (PROPOSALS + 3) /* ids from 1; two more for the proposals after messages get through */

#define READABLE 1
#define ARRIVAL 2
#define FRESH 4
#define DECISION 8
#define LIMIT 16
#define PROGRESS 32
#ifndef CHECKED
#define CHECKED 63
#endif
#define check(property, condition) assert(!(CHECKED & (property)) || (condition))

#define STATION 0
#define AGENT 1

/* Keys. 0 stands for none. */
#define SESSION_KEY(s) (1 + (s))
#ifdef FRESH_ANSWERS
#define KEY(proposer, id, answer) (3 + 2 * ((proposer) * IDS + (id)) + (answer))
#else
#define KEY(proposer, id, answer) (3 + (proposer) * IDS + (id))
#endif
#define MIXED_KEY 30 /* from a proposal, and the answer to another */
#define bit(n) (1 << (n))

/* States of an own proposal and of one of the peer. */
#define NOTHING 0
#define QUEUED 1
#define PROPOSED 2
#define ACCEPTED 1
#define OVERDUE 2 /* the owner was notified of the failure, but the proposer may have committed */

/* States of the followed record. */
#define UNSENT 0
#define FLYING 1
#define ARRIVED 2
#define LOST 3

#ifdef REKEY
#define SOFT_LIMIT 1
#define HARD_LIMIT 2
#define PHASES 1
#else
#define PHASES 3 /* the open proposals, then one more of each end */
#endif

typedef Side {
    byte session;
    byte epoch, key, previous, next; /* the live epochs */
    byte made;                       /* own proposals; the id of the newest */
    byte own;
    byte newest, theirs;             /* newest id of the peer, and its state if it was accepted */
    bool settled, confirming;
    bool peerMoved, countKnown;
    int begun;                       /* keys under which it has sealed */
    byte failed;                     /* own proposals of whose failure the owner was notified */
#ifdef REKEY
    byte sent;
    bool tried;
#endif
    /* Messages that it has sent; what each was sealed under. */
    byte proposes, accepts, secondAccepts, refuses;
    int confirmeds;
    byte proposeSeal[IDS], proposeEpoch[IDS], answerSeal[IDS];
};
Side side[2];
bool replaced; /* the two ends are not in the same session */
bool over;     /* the final check was made */
byte probe, probeOf, probeSeal; /* the followed record, its sender, its key */

#include "live_switch_steps.pml"

/* ---- the world */

active [2] proctype Ends()
{
    byte x = _pid;
    do
    /* A wish of the owner, also while another is open. A rekey by itself is one of these wishes, at certain times. */
#ifdef REKEY
    :: d_step { !over && rekeyDue(x) && side[x].made < PROPOSALS -> side[x].tried = true; wish(x) }
#ifdef NO_HARD_LIMIT
    :: d_step { !over && side[x].sent <= HARD_LIMIT -> side[x].sent++; check(LIMIT, side[x].sent <= HARD_LIMIT) }
#else
    :: d_step { !over && side[x].sent < HARD_LIMIT -> side[x].sent++; check(LIMIT, side[x].sent <= HARD_LIMIT) }
#endif
#else
    :: d_step { !over && side[x].key && side[x].made < PROPOSALS -> wish(x) }
#endif
    :: d_step { side[x].own == QUEUED && !peersTurn(x) && ready(x) -> propose(x) }
    /* Timers. */
    :: d_step { side[x].own -> giveUp(x) }
    :: d_step {
        side[x].theirs == ACCEPTED ->
#ifdef DROP_PREPARED
        side[x].theirs = NOTHING; side[x].next = 0
#else
        side[x].theirs = OVERDUE
#endif
       }
    :: d_step { side[x].previous && side[x].peerMoved && !underway(x) -> side[x].previous = 0 }
#ifndef REKEY
    /* The followed record. */
    :: d_step { !over && side[x].key && probe == UNSENT -> probe = FLYING; probeOf = x; probeSeal = side[x].key }
#ifdef SEND_PREVIOUS
    :: d_step { side[x].previous && probe == UNSENT -> probe = FLYING; probeOf = x; probeSeal = side[x].previous }
#endif
    :: d_step { probe == FLYING && probeOf == x -> handleProbe() }
    :: d_step { probe == FLYING && probeOf == x -> probe = LOST }
#endif
    od
}

/* Everything that is about the proposal `id` of x, and about the epoch to which it leads. */
proctype Network(byte x, id)
{
    do
    :: d_step {
        side[x].proposes & bit(id) && reads(1 - x, side[x].proposeSeal[id]) -> handlePropose(1 - x, id, true) }
#ifdef REFUSALS
    :: d_step {
        side[x].proposes & bit(id) && reads(1 - x, side[x].proposeSeal[id]) -> handlePropose(1 - x, id, false) }
    :: d_step {
        side[1 - x].refuses & bit(id) && reads(x, side[1 - x].answerSeal[id]) -> handleRefuse(x, id) }
#endif
    :: d_step {
        side[1 - x].accepts & bit(id) && reads(x, side[1 - x].answerSeal[id]) -> handleAccept(x, id, 0) }
#ifdef FRESH_ANSWERS
    :: d_step {
        side[1 - x].secondAccepts & bit(id) && reads(x, side[1 - x].answerSeal[id]) -> handleAccept(x, id, 1) }
#endif
    :: d_step {
        side[x].begun & bit(KEY(x, id, 0)) && reads(1 - x, KEY(x, id, 0)) -> opened(1 - x, KEY(x, id, 0)) }
    :: d_step {
        side[1 - x].begun & bit(KEY(x, id, 0)) && reads(x, KEY(x, id, 0)) -> opened(x, KEY(x, id, 0)) }
    :: d_step {
        side[x].begun & bit(KEY(x, id, 0)) && reads(1 - x, KEY(x, id, 0)) -> handleConfirm(1 - x, KEY(x, id, 0)) }
    :: d_step {
        side[1 - x].confirmeds & bit(KEY(x, id, 0)) && reads(x, KEY(x, id, 0)) -> handleConfirmed(x, KEY(x, id, 0)) }
    od
}

inline beginSession(beginner, sessionNumber)
{
    side[beginner].session = sessionNumber;
    side[beginner].epoch = 0;
#ifdef OLD_KEYS
    side[beginner].key = SESSION_KEY(0);
#else
    side[beginner].key = SESSION_KEY(sessionNumber);
#endif
    side[beginner].previous = 0;
    side[beginner].next = 0;
    side[beginner].own = NOTHING;
    side[beginner].newest = 0;
    side[beginner].theirs = NOTHING;
    side[beginner].settled = true;
    side[beginner].confirming = false;
    side[beginner].peerMoved = false;
    side[beginner].countKnown = false;
    check(FRESH, !(side[beginner].begun & bit(side[beginner].key)));
    side[beginner].begun = side[beginner].begun | bit(side[beginner].key)
}

#ifdef REPLACEMENT
inline crash(victim)
{
    side[victim].key = 0;
    side[victim].previous = 0;
    side[victim].next = 0;
    side[victim].own = NOTHING;
    side[victim].theirs = NOTHING;
    side[victim].confirming = false;
    side[victim].settled = true
}

/* An end crashes, or the station finds the session silent; the station begins a new session, then the agent does on the
   station's first record (session.pml has the details). */
active proctype Replacement()
{
    if
    :: d_step { side[STATION].key -> crash(STATION); replaced = true; probe = ARRIVED }
    :: d_step { side[STATION].key -> crash(AGENT); replaced = true; probe = ARRIVED }
    :: d_step { side[STATION].key -> replaced = true; probe = ARRIVED }
    fi;
    d_step { !over -> beginSession(STATION, 1) };
    d_step { !over -> beginSession(AGENT, 1); replaced = false }
}
#endif

init
{
    byte x, id;
    atomic {
        for (x : STATION .. AGENT) {
            side[x].key = SESSION_KEY(0);
            side[x].begun = bit(SESSION_KEY(0));
            side[x].settled = true;
            for (id : 1 .. PROPOSALS) {
                run Network(x, id)
            }
        };
        x = 0;
        id = 0
    }
}

/* In every state, all that the two ends would send now, or soon, can be read. */
active proctype Readable()
{
end:
    d_step {
        sameSession && !over && !(reads(AGENT, side[STATION].key) && reads(STATION, side[AGENT].key)) ->
        check(READABLE, false)
    }
}

/* ---- as soon as messages get through */

byte a, i, round, phase, before[2];
bool open[2], proposed[2];

inline recordsOf(speaker)
{
    if
    :: probe == FLYING && probeOf == speaker -> handleProbe()
    :: else
    fi;
    if
    :: reads(1 - (speaker), side[speaker].key) -> opened(1 - (speaker), side[speaker].key)
    :: else
    fi;
    if
#ifdef CONFIRM_ONCE
    :: side[speaker].confirming && reads(1 - (speaker), side[speaker].key) && proposed[speaker] ->
#else
    :: side[speaker].confirming && reads(1 - (speaker), side[speaker].key) ->
#endif
        handleConfirm(1 - (speaker), side[speaker].key);
        if
        :: side[1 - (speaker)].confirmeds & bit(side[speaker].key) -> handleConfirmed(speaker, side[speaker].key)
        :: else
        fi
    :: else
    fi
}

/* What both ends send in one round trip: first all proposals arrive, then all answers, then all else. */
inline roundTrip()
{
    for (a : STATION .. AGENT) {
#ifdef REKEY
        if
        :: rekeyDue(a) && side[a].made < IDS - 1 -> side[a].tried = true; wish(a)
        :: else
        fi;
#endif
        if
        :: side[a].own == QUEUED && !peersTurn(a) && ready(a) -> propose(a)
        :: else
        fi;
        proposed[a] = (side[a].own == PROPOSED)
    }
    for (a : STATION .. AGENT) {
        i = side[a].made;
        if
        :: proposed[a] && reads(1 - a, side[a].proposeSeal[i]) -> handlePropose(1 - a, i, true)
        :: else
        fi
    }
    for (a : STATION .. AGENT) {
        i = side[a].made;
        if
        :: proposed[a] && side[1 - a].refuses & bit(i) -> handleRefuse(a, i)
        :: proposed[a] && side[1 - a].accepts & bit(i) && !(side[1 - a].refuses & bit(i)) &&
           reads(a, side[1 - a].answerSeal[i]) -> handleAccept(a, i, 0)
        :: else
        fi
    }
    for (a : STATION .. AGENT) {
        recordsOf(a)
    }
    for (a : STATION .. AGENT) {
        if
        :: side[a].previous && side[a].peerMoved -> side[a].previous = 0
        :: else
        fi;
#ifndef WAIT_FOREVER
        if
        :: round & 1 && side[a].theirs == ACCEPTED -> side[a].theirs = OVERDUE
        :: else
        fi
#endif
    }
}

#define quietAt(x) (!side[x].own && side[x].settled && !side[x].confirming && !peersTurn(x))
#define quiet \
    (quietAt(STATION) && quietAt(AGENT) && side[STATION].key == side[AGENT].key && side[STATION].epoch == side[AGENT].epoch)
#define openAt(x) (side[x].own && !(side[1 - (x)].refuses & bit(side[x].made)))

active proctype MessagesGetThrough()
{
end:
    d_step {
        sameSession && !over && !replaced ->
        over = true;
        open[STATION] = openAt(STATION);
        open[AGENT] = openAt(AGENT);
        phase = 0;
        do
        :: phase == PHASES -> break
        :: else ->
            before[STATION] = side[STATION].epoch;
            before[AGENT] = side[AGENT].epoch;
            if
            :: phase -> wish(phase - 1); open[phase - 1] = true
            :: else
            fi;
            round = 0;
            do
            :: round == 6 -> break
            :: else -> roundTrip(); round++
            od;
            check(PROGRESS, quiet);
            check(PROGRESS, !open[STATION] || side[STATION].epoch > before[STATION]);
            check(PROGRESS, !open[AGENT] || side[AGENT].epoch > before[AGENT]);
            phase++
        od;
#ifdef REKEY
        check(PROGRESS, side[STATION].sent < SOFT_LIMIT && side[AGENT].sent < SOFT_LIMIT);
#endif
        /* One final state for all. */
        for (a : STATION .. AGENT) {
            side[a].session = 0; side[a].epoch = 0; side[a].key = 0; side[a].previous = 0; side[a].next = 0;
            side[a].made = 0; side[a].own = 0; side[a].newest = 0; side[a].theirs = 0;
            side[a].settled = false; side[a].confirming = false; side[a].peerMoved = false; side[a].countKnown = false;
            side[a].begun = 0; side[a].failed = 0; side[a].proposes = 0; side[a].accepts = 0; side[a].secondAccepts = 0;
            side[a].refuses = 0; side[a].confirmeds = 0;
#ifdef REKEY
            side[a].sent = 0; side[a].tried = false;
#endif
            for (i : 0 .. IDS - 1) {
                side[a].proposeSeal[i] = 0; side[a].proposeEpoch[i] = 0; side[a].answerSeal[i] = 0
            }
        }
        for (a : STATION .. AGENT) {
            before[a] = 0; open[a] = false; proposed[a] = false
        }
        a = 0; i = 0; round = 0; phase = 0; probe = ARRIVED; probeOf = 0; probeSeal = 0
    }
}
