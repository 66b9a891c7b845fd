// Listens to all that is said, and tells how much that was: an agent without a robot.

interval(10). // How often it tells [s].

!tell.

@count[atomic]
+heard(Topic, From, _)
   <- ?heard_before(N);
      -+heard_so_far(N + 1, From, Topic).

heard_before(N) :- heard_so_far(N, _, _).
heard_before(0) :- not heard_so_far(_, _, _).

+!tell : interval(Seconds) & heard_so_far(N, From, Topic)
   <- state("has heard ", N, " messages, the newest from ", From, " on ", Topic);
      .wait(Seconds * 1000);
      !!tell.
+!tell : interval(Seconds)
   <- state("listening");
      .wait(Seconds * 1000);
      !!tell.
