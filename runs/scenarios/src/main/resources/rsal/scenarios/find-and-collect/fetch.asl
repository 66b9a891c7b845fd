// Has collectors fetch what explorers have found, by contract net: who is nearest and free gets it.

patience(1).   // How long it waits for bids [s].
again(3).      // After what time it calls again for what nobody could take on [s].
deadline(20).  // After what time it asks whoever has got something whether it is still at it [s].
asks(5).       // How often it asks, a second each, before it has another fetch it.

next(1).

distance(X1, Y1, X2, Y2, D) :- D = math.sqrt((X1 - X2) ** 2 + (Y1 - Y2) ** 2).
known(X, Y) :- thing(_, _, OtherX, OtherY) & distance(X, Y, OtherX, OtherY, D) & D < 0.6.
collected(X, Y) :- depot(_, DepotX, DepotY) & distance(X, Y, DepotX, DepotY, D) & D < 1.5.
carried(X, Y) :- at(_, RobotX, RobotY, Time) & system.time - Time < 5000 & distance(X, Y, RobotX, RobotY, D) & D < 0.8.

!start.
+!start
   <- .df_register(fetch);
      state("nothing to fetch").

+heard(pose, _, pose_report(Robot, _, pose(X, Y, _)))
   <- -at(Robot, _, _, _);
      +at(Robot, X, Y, system.time).
+heard(depot, _, depot(Robot, point(X, Y), _))
   <- -depot(Robot, _, _);
      +depot(Robot, X, Y).

// Explorers say again what they still see: new is what lies in no depot and is on no robot.
@found[atomic]
+!found(Color, X, Y) : not known(X, Y) & not collected(X, Y) & not carried(X, Y) & next(Id)
   <- -+next(Id + 1);
      +thing(Id, Color, X, Y);
      !!bring(Id).
+!found(_, _, _).

// Called for until somebody has brought it, or has not found it there.
+!bring(Id) : thing(Id, Color, X, Y) & patience(Seconds)
   <- .abolish(bid(Id, _));
      .abolish(refused(Id));
      .df_search(collect, Collectors);
      .send(Collectors, achieve, call(Id, Color, X, Y));
      .wait(Seconds * 1000);
      .findall(offer(Cost, Who), bid(Id, Cost)[source(Who)], Offers);
      !award(Id, Offers);
      !!bring(Id).
+!bring(_).

// Ends when nobody is at it any more.
+!award(_, []) : again(Seconds)
   <- .wait(Seconds * 1000).
+!award(Id, Offers) : thing(Id, Color, X, Y) & .min(Offers, offer(Cost, Winner))
   <- .send(Winner, achieve, fetch(Id, Color, X, Y));
      state("thing ", Id, " goes to ", Winner);
      .delete(offer(Cost, Winner), Offers, Others);
      for (.member(offer(_, Loser), Others)) {
         !!reject(Id, Loser)
      };
      !watch(Id, Winner).
+!award(_, _).
-!award(Id, Offers)[error(receiver_not_found)] : .min(Offers, offer(Cost, Gone))
   <- .delete(offer(Cost, Gone), Offers, Others);
      !award(Id, Others).

+!reject(Id, Loser)
   <- .send(Loser, signal, rejected(Id)).
-!reject(_, _). // it has gone

+!watch(Id, Who) : deadline(Seconds) & asks(Times)
   <- .wait(refused(Id)[source(Who)] | not thing(Id, _, _, _), Seconds * 1000, _);
      !ask(Id, Who, Times).

+!ask(Id, _, _) : not thing(Id, _, _, _).
+!ask(Id, Who, _) : refused(Id)[source(Who)] & again(Seconds)
   <- .wait(Seconds * 1000).
+!ask(Id, Who, 0)
   <- state(Who, " does not answer").
+!ask(Id, Who, Times)
   <- .send(Who, askOne, job(Id, _), Answer, 1000);
      !answered(Id, Who, Times, Answer).
-!ask(_, Who, _)[error(receiver_not_found)]
   <- state(Who, " has gone").

+!answered(Id, Who, _, job(_, doing))
   <- !watch(Id, Who).
+!answered(Id, _, _, job(_, _)) // that it is over has been lost
   <- !close(Id).
+!answered(Id, Who, Times, timeout)
   <- !ask(Id, Who, Times - 1).
+!answered(_, _, _, false). // that it is to fetch it has been lost

+fetched(Id)
   <- !close(Id).
+failed(Id) // when it still lies there, it will be found again
   <- !close(Id).
+!close(Id)
   <- .abolish(thing(Id, _, _, _));
      .abolish(bid(Id, _));
      .abolish(refused(Id));
      .abolish(fetched(Id));
      .abolish(failed(Id)).
