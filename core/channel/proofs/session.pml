/* The begin and the replacement of a session (PROTOCOL.md, sections 4, 4.2 and 9): a station and an agent that crash, over a
   network that loses, repeats and reorders.

   Network: a message that was sent once can arrive at any later time, any number of times, or never. A first message is its
   counter (and 8 more after the station lost its counter, since its other contents are fresh). An answer, and the session to
   which it leads, is the number of the agent's ephemeral key, with the first message that it answers. With THIEF, an attacker
   with the agent's private key writes a first message in the station's name with the greatest counter; only the station could
   confirm it.

   Time: each timer may fire at any time. The agent has 2 unconfirmed sessions instead of 4.

   Properties:
     FRESH     no end begins a session with the same keys twice.
     ENDED     the agent ends a session only if the station has left it; the station, only for a newer one.
     KEPT      an answer that the station takes is still there at the agent, unless 10 s have passed, the agent has crashed, or
               the station has confirmed a newer one.
     COUNTER   the agent stores no counter that the station has not used.
     PROGRESS  from every reachable state, as soon as messages get through, both ends have the same session up.

   The lines below are read by tests/proofs/prove.py, as in live_switch.pml.

   run                                                   holds
   run THIEF                                             holds
   run COUNTERS=2 LOST_COUNTER CHECKED=25                holds       all but ENDED and KEPT
   run LOST_COUNTER              violates ENDED          a late record may return to a session of the station's former life
   run END_EARLY                 violates ENDED          an unconfirmed session ends the one that is up
   run KEEP_LOWER                violates ENDED          unconfirmed sessions of lower counters outlive a confirmation
   run TRUST_ANNOUNCEMENTS       violates ENDED          an announcement ends the station's session
   run THIEF STORE_EARLY         violates COUNTER        the counter is stored before the confirmation
   run THIEF STORE_EARLY         violates PROGRESS       the same
   run OLDEST_FIRST              violates KEPT           the oldest unconfirmed session is discarded, whatever its counter
   run ANSWER_COPIES             violates KEPT           a copy of a first message gets another answer
   run KEEP_KEYS                 violates FRESH          the station goes on with the keys of its session after a crash
   run LOST_COUNTER NO_NUMBER    violates PROGRESS       the agent does not send its number
*/

#ifndef COUNTERS
#define COUNTERS 3 /* first messages, before messages get through */
#endif
#ifndef ANSWERS
#define ANSWERS 4  /* sessions that the agent prepares, likewise */
#endif
#ifndef CRASHES
#define CRASHES 2  /* of both ends together */
#endif

#define FRESH 1
#define ENDED 2
#define KEPT 4
#define COUNTER 8
#define PROGRESS 16
#ifndef CHECKED
#define CHECKED 31
#endif
#define check(property, condition) assert(!(CHECKED & (property)) || (condition))
#define bit(n) (1 << (n))
#define GREATEST 16 /* counter of the thief, and a number that no station believes */
#define MOST (ANSWERS + 4)
#define value(message) ((message) == GREATEST -> GREATEST : (message) & 7)

/* The station. Sessions are numbered from 1 as answers are; 0 stands for none. */
byte counter;        /* newest that was used, on disk */
byte used;           /* newest that was ever used */
byte attempt;        /* the present first message */
byte losses;         /* of the counter */
byte stationUp;
int stationBegun;    /* sessions begun so far */

/* The agent. */
byte seen;           /* greatest counter that was confirmed, on disk */
byte agentUp;
byte answers;        /* made so far */
byte unconfirmed[2]; /* the older one first */
int excused;         /* sessions that were dropped because of time, a crash, or a newer confirmed one */

/* Sent so far. */
int firsts;          /* first messages */
byte firstOf[MOST];
int records;         /* sessions under which the station has sealed */
int numbers;         /* first messages that got a number */
byte crashes;
bool over;

/* ---- the agent */

inline drop(dropped, isExcused)
{
    if
    :: isExcused && dropped -> excused = excused | bit(dropped)
    :: else
    fi
}

inline endAgents()
{
    check(ENDED, !agentUp || agentUp != stationUp);
    agentUp = 0
}

/* Makes room among the unconfirmed sessions: discards the oldest that does not have the greatest counter. */
inline makeRoom()
{
    if
    :: unconfirmed[0] && unconfirmed[1] ->
#ifdef OLDEST_FIRST
        unconfirmed[0] = unconfirmed[1];
#else
        if
        :: value(firstOf[unconfirmed[0]]) >= value(firstOf[unconfirmed[1]]) -> skip
        :: else -> unconfirmed[0] = unconfirmed[1]
        fi;
#endif
        unconfirmed[1] = 0
    :: !unconfirmed[0] && unconfirmed[1] -> unconfirmed[0] = unconfirmed[1]; unconfirmed[1] = 0
    :: else
    fi
}

#ifdef ANSWER_COPIES
#define isCopy(c) false
#else
#define isCopy(c) \
    ((unconfirmed[0] && firstOf[unconfirmed[0]] == (c)) || (unconfirmed[1] && firstOf[unconfirmed[1]] == (c)))
#endif

inline handleFirst(claimed)
{
    if
    :: isCopy(claimed) /* the same answer again */
    :: !isCopy(claimed) && value(claimed) <= seen -> numbers = numbers | bit(claimed)
    :: else ->
        makeRoom();
        answers++;
        firstOf[answers] = claimed;
        if
        :: !unconfirmed[0] -> unconfirmed[0] = answers
        :: else -> unconfirmed[1] = answers
        fi;
#ifdef STORE_EARLY
        seen = value(claimed);
        check(COUNTER, seen <= used);
#endif
#ifdef END_EARLY
        endAgents()
#endif
    fi
}

/* A record of the station under an unconfirmed session. */
inline confirm(confirmed)
{
    if
    :: agentUp -> endAgents()
    :: else
    fi;
    agentUp = confirmed;
    seen = (value(firstOf[confirmed]) > seen -> value(firstOf[confirmed]) : seen);
    check(COUNTER, seen <= used);
    if
    :: unconfirmed[0] == confirmed -> unconfirmed[0] = 0
    :: unconfirmed[1] == confirmed -> unconfirmed[1] = 0
    fi;
#ifndef KEEP_LOWER
    if
    :: unconfirmed[0] && value(firstOf[unconfirmed[0]]) <= seen -> drop(unconfirmed[0], true); unconfirmed[0] = 0
    :: else
    fi;
    if
    :: unconfirmed[1] && value(firstOf[unconfirmed[1]]) <= seen -> drop(unconfirmed[1], true); unconfirmed[1] = 0
    :: else
    fi
#endif
}

active proctype Agent()
{
    byte i;
    do
    :: d_step { !over && unconfirmed[0] -> drop(unconfirmed[0], true); unconfirmed[0] = unconfirmed[1]; unconfirmed[1] = 0 }
    :: d_step { !over && unconfirmed[1] -> drop(unconfirmed[1], true); unconfirmed[1] = 0 }
    :: d_step {
        !over && crashes < CRASHES ->
        crashes++;
        agentUp = 0;
        drop(unconfirmed[0], true);
        drop(unconfirmed[1], true);
        unconfirmed[0] = 0;
        unconfirmed[1] = 0
       }
    od
}

/* ---- the station */

inline newFirst()
{
    counter++;
    used = (counter > used -> counter : used);
    attempt = counter + 8 * losses;
    firsts = firsts | bit(attempt)
}

inline endStations(newer)
{
    check(ENDED, newer && value(firstOf[newer]) > value(firstOf[stationUp]));
    stationUp = 0
}

inline beginSession(begun)
{
    check(FRESH, !(stationBegun & bit(begun)));
    stationBegun = stationBegun | bit(begun);
    stationUp = begun;
    records = records | bit(begun)
}

inline handleAnswer(answered)
{
    check(KEPT, firsts & bit(GREATEST) || agentUp == (answered) || unconfirmed[0] == (answered) ||
          unconfirmed[1] == (answered) || (excused & bit(answered)));
    attempt = 0;
    if
    :: stationUp -> endStations(answered)
    :: else
    fi;
    beginSession(answered)
}

inline handleNumber()
{
    if
    :: seen >= counter && seen < GREATEST -> counter = seen
    :: else
    fi;
    newFirst()
}

active proctype Station()
{
    do
    /* An announcement, a call, or silence: the attempt begins, or gets a fresh first message. */
    :: d_step { !over && counter < COUNTERS -> newFirst() }
    /* An authentic record of the session that is up ends the attempt. */
    :: d_step { !over && attempt && stationUp && stationUp == agentUp -> attempt = 0 }
    :: d_step {
        !over && crashes < CRASHES ->
        crashes++;
        attempt = 0;
#ifdef KEEP_KEYS
        if
        :: stationUp -> beginSession(stationUp)
        :: else
        fi
#else
        stationUp = 0
#endif
       }
#ifdef LOST_COUNTER
    :: d_step { !over && !losses -> losses = 1; attempt = 0; stationUp = 0; counter = 0 }
#endif
#ifdef TRUST_ANNOUNCEMENTS
    :: d_step { !over && stationUp -> endStations(0) }
#endif
    od
}

/* ---- the network */

/* Everything that is about the first message with the counter c. */
proctype First(byte c)
{
    do
    :: d_step { !over && firsts & bit(c) && answers < ANSWERS -> handleFirst(c) }
#ifndef NO_NUMBER
    :: d_step { !over && numbers & bit(c) && attempt == c && counter < COUNTERS && seen < COUNTERS -> handleNumber() }
#endif
    od
}

/* Everything that is about the session s. */
proctype Session(byte s)
{
    do
    :: d_step { !over && s <= answers && attempt && firstOf[s] == attempt -> handleAnswer(s) }
    :: d_step { !over && records & bit(s) && (unconfirmed[0] == s || unconfirmed[1] == s) -> confirm(s) }
    od
}

#ifdef THIEF
active proctype Thief()
{
    d_step { !over -> firsts = firsts | bit(GREATEST) }
}
#endif

init
{
    byte n;
    atomic {
        for (n : 1 .. COUNTERS) {
            run First(n);
#ifdef LOST_COUNTER
            run First(n + 8)
#endif
        }
#ifdef THIEF
        run First(GREATEST);
#endif
        for (n : 1 .. ANSWERS) {
            run Session(n)
        }
        n = 0
    }
}

/* ---- as soon as messages get through */

byte n, round;
#define settled (stationUp && stationUp == agentUp)

/* The station finds the session silent, or hears an announcement, and both ends exchange what follows. */
inline handshake()
{
    unconfirmed[0] = 0;
    unconfirmed[1] = 0;
    newFirst();
    n = answers;
    handleFirst(attempt);
#ifndef NO_NUMBER
    if
    :: n == answers && numbers & bit(attempt) -> handleNumber(); handleFirst(attempt)
    :: else
    fi;
#endif
    if
    :: answers > n ->
        n = answers;
        handleAnswer(n);
        if
        :: unconfirmed[0] == n || unconfirmed[1] == n -> confirm(n)
        :: else
        fi
    :: else
    fi
}

active proctype MessagesGetThrough()
{
end:
    d_step {
        !over ->
        over = true;
        if
        :: stationUp && (unconfirmed[0] == stationUp || unconfirmed[1] == stationUp) -> n = stationUp; confirm(n)
        :: else
        fi;
        round = 0;
        do
        :: settled || round == 2 -> break
        :: else -> handshake(); round++
        od;
        check(PROGRESS, settled);
        /* One final state for all. */
        counter = 0; used = 0; attempt = 0; losses = 0; stationUp = 0; stationBegun = 0; seen = 0; agentUp = 0; answers = 0;
        unconfirmed[0] = 0; unconfirmed[1] = 0; excused = 0; firsts = 0; records = 0; numbers = 0; crashes = 0; round = 0;
        for (n : 0 .. MOST - 1) {
            firstOf[n] = 0
        }
        n = 0
    }
}
