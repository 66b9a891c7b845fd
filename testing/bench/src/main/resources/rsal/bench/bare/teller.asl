// Tells all others its pose ten times a second, and counts the poses that it is told.

count(0).

!begin.
+!begin
   <- !!tell(system.time).

+!tell(Due)
   <- .broadcast(signal, pose(0, 0, 0));
      Next = math.max(Due + 100, system.time); // what was late is not made up for
      .wait(math.max(0, Next - system.time));
      !!tell(Next).

@heard[atomic]
+pose(_, _, _)[source(_)] : count(N)
   <- -+count(N + 1).
