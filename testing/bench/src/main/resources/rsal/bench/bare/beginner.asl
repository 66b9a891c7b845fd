// Has begun, and does no more.

count(0).

!begin.
+!begin
   <- -+count(1).
