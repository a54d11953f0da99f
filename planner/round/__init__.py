"""What one tick's planning works on: who plans, what it knows, what it wishes, and how a planner is called."""
