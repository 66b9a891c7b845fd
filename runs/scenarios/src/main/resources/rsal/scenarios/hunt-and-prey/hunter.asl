// Hunter: goes for the newest pose of a prey until that has been caught, then for the next.

prey(prey).          // Role of the robots to hunt, or id of the one.
catchDistance(2.0).  // It stops when nearer to its prey than this [m].
period(0.5).         // How often it says where it is [s].
interval(2).         // How often it goes for the prey's newest pose [s].
assignment(fixed).   // fixed: it hunts a prey until that has been caught; else it chooses anew each time.

is_prey(Robot, Role) :- robot(Me, _) & Robot \== Me & (prey(Robot) | prey(Role)).
distance(X, Y, D) :- pose(MyX, MyY, _) & D = math.sqrt((X - MyX) ** 2 + (Y - MyY) ** 2).
near(X, Y) :- catchDistance(Near) & distance(X, Y, D) & D < Near & .in_sight(X, Y).

// The nearest prey, one that others hunt as if it were ten meters farther for each of them.
cost(Prey, Cost) :- seen(Prey, X, Y) & distance(X, Y, D) & .count(chases(_, Prey), Others) & Cost = D + 10 * Others.
keeps(Prey) :- assignment(fixed) & target(Prey) & seen(Prey, _, _).
choice(Prey) :- keeps(Prey).
choice(Prey) :- not keeps(_) & .findall(c(Cost, Each), cost(Each, Cost), All) & .min(All, c(_, Prey)).

!report.
!hunt.

+!report : pose(X, Y, Th) & robot(Me, Role) & period(Seconds)
   <- publish(pose, Me, Role, pose(X, Y, Th));
      .wait(Seconds * 1000);
      !!report.
+!report : period(Seconds) // it does not know yet where it is
   <- .wait(Seconds * 1000);
      !!report.

+heard(pose, _, pose_report(Prey, Role, pose(X, Y, _))) : is_prey(Prey, Role) & not caught(Prey)
   <- -seen(Prey, _, _);
      +seen(Prey, X, Y).
+heard(chase, _, chase(Hunter, Prey))
   <- -chases(Hunter, _);
      +chases(Hunter, Prey).
+heard(caught, _, caught(Prey, _, _))
   <- +caught(Prey);
      -seen(Prey, _, _);
      !release(Prey).

+!release(Prey) : target(Prey)
   <- -target(Prey);
      stop;
      !pursue.
+!release(_).

+!hunt : interval(Seconds)
   <- !pursue;
      .wait(Seconds * 1000);
      !!hunt.

+!pursue : choice(Prey) & seen(Prey, X, Y)
   <- !take_on(Prey);
      !approach(Prey, X, Y).
+!pursue
   <- state("looking for prey").

+!take_on(Prey) : target(Prey).
+!take_on(Prey) : robot(Me, _)
   <- -+target(Prey);
      publish(chase, Me, Prey);
      show(prey, Prey).

+!approach(Prey, X, Y) : near(X, Y)
   <- stop;
      state("holding ", Prey, " at bay").
+!approach(Prey, X, Y)
   <- state("hunting ", Prey);
      !!go(X, Y).

+!go(X, Y)
   <- goto(X, Y).
-!go(_, _). // a newer goal has taken over, or the next try finds a way
