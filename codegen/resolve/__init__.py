"""Resolve: a specification and a dialect become one system, in which every name is looked up."""
