"""What each command does, from files or arrays to a result. Nothing is printed."""
