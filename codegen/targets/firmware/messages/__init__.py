"""Views and statements of what is sent and received: payloads, streams, receptions."""
