"""The quantities of the state: how each is kept, and where its value comes from."""
